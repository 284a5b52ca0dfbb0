#include "app/store/store_head_codec.hpp"

#include "app/store/store_bytes.hpp"

#include <stdexcept>

namespace app {

namespace {

void put_columns(std::string& bytes, const std::vector<Column>& columns)
{
    put(bytes, static_cast<std::uint64_t>(columns.size()));
    for (const Column& column : columns) {
        put_text(bytes, column.name);
        put_text(bytes, column.unit);
        put_text(bytes, column.meaning);
    }
}

std::vector<Column> take_columns(ByteDecoder& from)
{
    std::vector<Column> columns(static_cast<std::size_t>(from.count()));
    for (Column& column : columns) {
        column.name = from.text();
        column.unit = from.text();
        column.meaning = from.text();
    }
    return columns;
}

std::vector<StoreSession> take_sessions(ByteDecoder& from)
{
    std::vector<StoreSession> sessions(static_cast<std::size_t>(from.count()));
    for (StoreSession& session : sessions)
        for (std::string* text : {&session.program_version, &session.machine, &session.build,
                                  &session.settings, &session.started})
            *text = from.text();
    return sessions;
}

} // namespace

std::string encode_head(const StoreHead& head)
{
    std::string bytes;
    put_text(bytes, head.configuration);
    put_text(bytes, head.identity);
    put(bytes, static_cast<std::uint64_t>(head.levels.size()));
    for (const StoreLevel& level : head.levels) {
        put(bytes, level.vertical_stress);
        put(bytes, level.samples);
    }
    put(bytes, static_cast<std::uint64_t>(head.design_sizes.size()));
    put_all(bytes, head.design_sizes);
    put(bytes, head.seed);
    put(bytes, head.shard);
    put(bytes, head.shards);
    for (const auto* columns :
         {&head.inputs, &head.responses, &head.counts, &head.cost, &head.curve_columns})
        put_columns(bytes, *columns);
    put(bytes, static_cast<std::uint32_t>(head.single_precision_curves ? 1 : 0));
    put(bytes, static_cast<std::int32_t>(head.compression));
    put(bytes, static_cast<std::uint64_t>(head.sessions.size()));
    for (const StoreSession& session : head.sessions)
        for (const std::string* text : {&session.program_version, &session.machine,
                                        &session.build, &session.settings, &session.started})
            put_text(bytes, *text);
    return bytes;
}

StoreHead decode_head(std::string_view bytes, const std::string& file)
{
    ByteDecoder from(bytes, file);
    StoreHead head;
    head.configuration = from.text();
    head.identity = from.text();
    head.levels.resize(static_cast<std::size_t>(from.count()));
    for (StoreLevel& level : head.levels) {
        level.vertical_stress = from.value<double>();
        level.samples = from.value<std::uint32_t>();
    }
    head.design_sizes = from.values<std::uint32_t>(from.count());
    head.seed = from.value<std::uint64_t>();
    head.shard = from.value<std::uint32_t>();
    head.shards = from.value<std::uint32_t>();
    for (auto* columns :
         {&head.inputs, &head.responses, &head.counts, &head.cost, &head.curve_columns})
        *columns = take_columns(from);
    head.single_precision_curves = from.value<std::uint32_t>() != 0;
    head.compression = from.value<std::int32_t>();
    head.sessions = take_sessions(from);
    from.end();
    try {
        check_head(head);
    } catch (const std::invalid_argument& error) {
        throw StoreError(file + ": damaged: " + error.what());
    }
    return head;
}

} // namespace app
