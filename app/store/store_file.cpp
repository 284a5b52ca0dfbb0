#include "app/store/store_file.hpp"

#include "app/store/store_columns.hpp"
#include "app/store/store_error.hpp"
#include "app/store/store_head_codec.hpp"
#include "app/store/store_seal.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <unistd.h>

namespace app {

namespace {

namespace fs = std::filesystem;
using hdf5::ColumnWriter;
using hdf5::put_attribute;
using hdf5::Shape;
using hdf5::StudyColumns;

fs::path with_suffix(const fs::path& file, const char* suffix)
{
    fs::path name = file;
    name += suffix;
    return name;
}

template <class T, class Field>
std::vector<std::string> texts_of(const std::vector<T>& list, Field field)
{
    std::vector<std::string> texts;
    for (const T& item : list) texts.push_back(item.*field);
    return texts;
}

void write_sessions(const hdf5::File& file, const std::vector<StoreSession>& sessions)
{
    using S = StoreSession;
    hdf5::make_group(file, "/sessions");
    hdf5::put_texts(file, "/sessions/program_version", texts_of(sessions, &S::program_version));
    hdf5::put_texts(file, "/sessions/machine", texts_of(sessions, &S::machine));
    hdf5::put_texts(file, "/sessions/build", texts_of(sessions, &S::build));
    hdf5::put_texts(file, "/sessions/settings", texts_of(sessions, &S::settings));
    hdf5::put_texts(file, "/sessions/started", texts_of(sessions, &S::started));
}

/// One number per row, at once.
template <class T>
void write_numbers(const hdf5::File& file, const std::string& name, hid_t file_type,
                   hid_t memory_type, const std::vector<T>& values)
{
    ColumnWriter column(file, name, Shape{file_type, memory_type, values.size()}, 0);
    column.append(values.data(), values.size());
    column.finish();
}

void write_levels(const hdf5::File& file, const StoreHead& head)
{
    std::vector<double> stress;
    std::vector<std::uint32_t> samples;
    for (const StoreLevel& level : head.levels) {
        stress.push_back(level.vertical_stress);
        samples.push_back(level.samples);
    }
    hdf5::make_group(file, "/levels");
    write_numbers(file, "/levels/vertical_stress", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, stress);
    put_attribute(file, "/levels/vertical_stress", "unit", "Pa");
    write_numbers(file, "/levels/samples", H5T_STD_U32LE, H5T_NATIVE_UINT32, samples);
    write_numbers(file, "/design_sizes", H5T_STD_U32LE, H5T_NATIVE_UINT32, head.design_sizes);
}

void write_head(const hdf5::File& file, const StoreHead& head)
{
    put_attribute(file, "/", "title", "drystone study; docs/store.md describes this file");
    put_attribute(file, "/", "layout", std::uint64_t{kStoreLayout});
    put_attribute(file, "/", "seed", head.seed);
    put_attribute(file, "/", "shard", std::uint64_t{head.shard});
    put_attribute(file, "/", "shards", std::uint64_t{head.shards});
    hdf5::put_text(file, "/configuration", head.configuration);
    hdf5::put_text(file, "/identity", head.identity);
    const std::string bytes = encode_head(head);
    write_numbers(file, "/head", H5T_STD_U8LE, H5T_NATIVE_UINT8,
                  std::vector<std::uint8_t>(bytes.begin(), bytes.end()));
    write_levels(file, head);
    write_sessions(file, head.sessions);
    for (const char* group : {"/walls", "/responses", "/counts", "/cost", "/curves"})
        hdf5::make_group(file, group);
    hdf5::put_texts(file, "/walls/input_name", texts_of(head.inputs, &Column::name));
    hdf5::put_texts(file, "/walls/input_unit", texts_of(head.inputs, &Column::unit));
    hdf5::put_texts(file, "/walls/input_meaning", texts_of(head.inputs, &Column::meaning));
}

constexpr const char* kMissing = "NaN: not defined for this wall";

void describe(const hdf5::File& file, const std::string& group,
              const std::vector<Column>& columns, bool with_nan)
{
    for (const Column& column : columns) {
        put_attribute(file, group + column.name, "unit", column.unit);
        put_attribute(file, group + column.name, "meaning", column.meaning);
        if (with_nan) put_attribute(file, group + column.name, "missing", kMissing);
    }
}

void append_row(StudyColumns<ColumnWriter>& to, const WallRow& row, std::size_t reason_bytes,
                std::uint64_t& offset)
{
    to.level.append(&row.key.level, 1);
    to.sample.append(&row.key.sample, 1);
    to.status.append(&row.status, 1);
    std::string reason = row.reason;
    reason.resize(reason_bytes, '\0');
    to.reason.append(reason.data(), 1);
    to.inputs.append(row.inputs.data(), 1);
    const auto each = [](std::vector<ColumnWriter>& columns, const auto& values) {
        for (std::size_t k = 0; k < columns.size(); ++k) columns[k].append(&values[k], 1);
    };
    each(to.responses, row.responses);
    each(to.counts, row.counts);
    each(to.cost, row.cost);
    const std::uint64_t points = row.curve.displacement.size();
    to.curve[0].append(row.curve.displacement.data(), points);
    to.curve[1].append(row.curve.force.data(), points);
    for (std::size_t k = 2; k < to.curve.size(); ++k)
        to.curve[k].append(row.curve.further[k - 2].data(), points);
    offset += points;
    to.offset.append(&offset, 1);
}

void finish(StudyColumns<ColumnWriter>& columns)
{
    for (ColumnWriter* column : {&columns.level, &columns.sample, &columns.status,
                                 &columns.reason, &columns.inputs, &columns.offset})
        column->finish();
    for (auto* list : {&columns.responses, &columns.counts, &columns.cost, &columns.curve})
        for (ColumnWriter& column : *list) column.finish();
}

void write_rows(const hdf5::File& file, const StoreHead& head, const RowSource& source)
{
    StoreSize size = source.size;
    size.reason_bytes = std::max<std::uint64_t>(1, size.reason_bytes);
    const hdf5::Handle reason = hdf5::text_type(size.reason_bytes);
    auto columns = hdf5::study_columns<ColumnWriter>(
        head, size, reason.get(), [&](const std::string& name, const Shape& shape) {
            return ColumnWriter(file, name, shape, head.compression);
        });
    std::uint64_t offset = 0;
    columns.offset.append(&offset, 1);
    for (std::size_t i = 0; i < size.walls; ++i)
        append_row(columns, source.row(i), size.reason_bytes, offset);
    finish(columns);
    describe(file, "/responses/", head.responses, true);
    describe(file, "/counts/", head.counts, false);
    describe(file, "/cost/", head.cost, true);
    describe(file, "/curves/", hdf5::all_curve_columns(head), true);
    put_attribute(file, "/walls/inputs", "missing", kMissing);
}

void tell(const StageHook& reached, StoreStage stage)
{
    if (reached) reached(stage);
}

/// Leaves nothing behind unless kept.
class Part {
  public:
    explicit Part(fs::path path) : path_(std::move(path)) { ::unlink(path_.c_str()); }
    ~Part()
    {
        if (!kept_) ::unlink(path_.c_str());
    }
    Part(const Part&) = delete;
    Part& operator=(const Part&) = delete;
    void rename_to(const fs::path& file)
    {
        if (::rename(path_.c_str(), file.c_str()) != 0) disk_error("write", file, errno);
        kept_ = true;
    }

  private:
    fs::path path_;
    bool kept_ = false;
};

} // namespace

std::vector<Column> hdf5::all_curve_columns(const StoreHead& head)
{
    std::vector<Column> columns{{"displacement", "m", "of the top of the wall"},
                                {"force", "N", "horizontal load"}};
    columns.insert(columns.end(), head.curve_columns.begin(), head.curve_columns.end());
    return columns;
}

fs::path part_of(const fs::path& file) { return with_suffix(file, ".part"); }
fs::path journal_of(const fs::path& file) { return with_suffix(file, ".journal"); }
fs::path lock_of(const fs::path& file) { return with_suffix(file, ".lock"); }

void replace_study_file(const fs::path& file, const StoreHead& head, const RowSource& source,
                        const StageHook& reached)
{
    const fs::path path = part_of(file);
    Part part(path);
    OpenFile disk(::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (!disk.is_open()) disk_error("write", path, errno);
    hdf5::File written = hdf5::create_file(path, std::move(disk));
    write_head(written, head);
    write_rows(written, head, source);
    disk = hdf5::close_file(std::move(written));
    tell(reached, StoreStage::rows_written);
    write_seal(disk, path);
    tell(reached, StoreStage::sealed);
    if (::fsync(disk.get()) != 0) disk_error("write", path, errno);
    tell(reached, StoreStage::synced);
    part.rename_to(file);
    sync_folder_of(file);
    tell(reached, StoreStage::renamed);
}

} // namespace app
