#include "app/store/stored_head.hpp"

#include "app/store/hdf5/hdf5_dataset.hpp"
#include "app/store/hdf5/store_error.hpp"
#include "app/store/pier_datasets.hpp"

#include <sstream>
#include <stdexcept>

namespace app {

namespace {

using hdf5::Dataset;
using hdf5::put_attribute;
using hdf5::text_attribute;

template <class T, class Member>
std::vector<std::string> texts(const std::vector<T>& list, Member member)
{
    std::vector<std::string> all;
    for (const T& item : list) all.push_back(item.*member);
    return all;
}

template <class T>
void put_numbers(const hdf5::File& file, const std::string& name, const std::vector<T>& values)
{
    Dataset(file, name, hdf5::type_of<T>(), {values.size()})
        .write(0, std::span<const T>(values));
}

template <class T> std::vector<T> numbers(const hdf5::File& file, const std::string& name)
{
    const Dataset from(file, name);
    return from.read<T>(0, from.rows());
}

/// Name in the file and field of each text of a session.
constexpr std::pair<const char*, std::string StoreSession::*> kSession[] = {
    {"/sessions/program_version", &StoreSession::program_version},
    {"/sessions/machine", &StoreSession::machine},
    {"/sessions/build", &StoreSession::build},
    {"/sessions/settings", &StoreSession::settings},
    {"/sessions/started", &StoreSession::started}};
constexpr const char* kLevelTurned = "/levels/turned"; // of studies of both directions
constexpr const char* kLevelSlower = "/levels/slower"; // not before revision 3 of the solver
constexpr const char* kSessionRevision = "/sessions/solver_revision"; // not before 0.2.0

constexpr std::pair<const char*, std::string Column::*> kInput[] = {
    {"/walls/input_name", &Column::name},
    {"/walls/input_unit", &Column::unit},
    {"/walls/input_meaning", &Column::meaning}};

/// Structs of texts from one dataset per field.
template <class T, class Fields>
std::vector<T> structs(const hdf5::File& file, const Fields& fields)
{
    std::vector<T> list;
    for (const auto& [name, member] : fields) {
        const std::vector<std::string> values = hdf5::texts_of(file, name, kMostTextBytes);
        if (member == fields[0].second) list.resize(values.size());
        if (values.size() != list.size())
            damaged(file.path, std::string(name) +
                                   " does not have as many rows as the datasets beside it");
        for (std::size_t i = 0; i < list.size(); ++i) list[i].*member = values[i];
    }
    return list;
}

/// Whether a file has what earlier versions did not write.
bool is_stored(const hdf5::File& file, const char* name)
{
    return file.checked(H5Lexists(file.id.get(), name, H5P_DEFAULT),
                        std::string("find ") + name + " in") > 0;
}

std::vector<StoreSession> sessions(const hdf5::File& file)
{
    auto list = structs<StoreSession>(file, kSession);
    if (!is_stored(file, kSessionRevision)) return list;
    const std::vector<std::string> revisions =
        hdf5::texts_of(file, kSessionRevision, kMostTextBytes);
    if (revisions.size() != list.size())
        damaged(file.path, "there is not a revision of the solver for each session");
    for (std::size_t i = 0; i < list.size(); ++i) list[i].solver_revision = revisions[i];
    return list;
}

std::vector<Column> columns(const hdf5::File& file, const std::string& group)
{
    std::vector<Column> list;
    std::istringstream names(text_attribute(file, group, "columns"));
    for (std::string name; names >> name;) {
        const std::string dataset = group + "/" + name;
        list.push_back({name, text_attribute(file, dataset, "unit"),
                        text_attribute(file, dataset, "meaning")});
    }
    return list;
}

std::string only_text(const hdf5::File& file, const std::string& name)
{
    const std::vector<std::string> list = hdf5::texts_of(file, name, kMostStudyBytes);
    if (list.size() != 1)
        damaged(file.path,
                name + " has " + std::to_string(list.size()) + " texts instead of one");
    return list.front();
}

void check_layout(const hdf5::File& file)
{
    const std::string path = "'" + file.path.string() + "'";
    if (file.checked(H5Aexists(file.id.get(), "layout"), "find its layout in") == 0)
        throw BadStoredStudy(path + " is an HDF5 file, but not of a study; name the file that "
                                    "`drystone study` wrote");
    const std::uint64_t layout = hdf5::number_attribute(file, "/", "layout");
    if (layout != kStoreLayout)
        throw BadStoredStudy(path + " has layout " + std::to_string(layout) +
                             ", this program knows " + std::to_string(kStoreLayout) +
                             "; use the version of the program that wrote it, or run the study "
                             "again into another file");
}

} // namespace

void put_head(const hdf5::File& file, const StoreHead& head)
{
    put_attribute(file, "/", "title", "drystone study; docs/store.md describes this file");
    put_attribute(file, "/", "layout", std::uint64_t{kStoreLayout});
    put_attribute(file, "/", "seed", head.seed);
    put_attribute(file, "/", "shard", std::uint64_t{head.shard});
    put_attribute(file, "/", "shards", std::uint64_t{head.shards});
    for (const char* group :
         {"/levels", "/sessions", "/walls", "/responses", "/counts", "/cost", "/curves"})
        hdf5::make_group(file, group);
    for (const PartGroup& parts : part_groups())
        if (!(head.*parts.stored).places.empty()) hdf5::make_group(file, parts.group);
    hdf5::put_texts(file, "/configuration", {head.configuration});
    hdf5::put_texts(file, "/identity", {head.identity});
    std::vector<double> stress;
    std::vector<std::uint32_t> samples, slower, turned;
    for (const StoreLevel& level : head.levels) {
        stress.push_back(level.vertical_stress);
        samples.push_back(level.samples);
        slower.push_back(level.slower);
        turned.push_back(level.turned ? 1 : 0);
    }
    put_numbers(file, "/levels/vertical_stress", stress);
    for (const char* name : {"unit", "units"}) // the second is what netCDF programs look for
        put_attribute(file, "/levels/vertical_stress", name, "Pa");
    put_numbers(file, "/levels/samples", samples);
    put_numbers(file, kLevelSlower, slower);
    if (has_turned(head)) put_numbers(file, kLevelTurned, turned);
    put_numbers(file, "/design_sizes", head.design_sizes);
    for (const auto& [name, member] : kSession)
        hdf5::put_texts(file, name, texts(head.sessions, member));
    hdf5::put_texts(file, kSessionRevision,
                    texts(head.sessions, &StoreSession::solver_revision));
    for (const auto& [name, member] : kInput)
        hdf5::put_texts(file, name, texts(head.inputs, member));
}

void put_columns(const hdf5::File& file, const StoreHead& head)
{
    constexpr const char* missing = "NaN: not defined for this wall";
    const auto put = [&](const std::string& group, const std::vector<Column>& list,
                         bool with_nan) {
        std::string names;
        for (const Column& column : list) {
            names += (names.empty() ? "" : " ") + column.name;
            const std::string dataset = group + "/" + column.name;
            put_attribute(file, dataset, "unit", column.unit);
            put_attribute(file, dataset, "units", column.unit == "-" ? "1" : column.unit);
            put_attribute(file, dataset, "meaning", column.meaning);
            if (with_nan) put_attribute(file, dataset, "missing", missing);
        }
        put_attribute(file, group, "columns", names);
    };
    put("/responses", head.responses, true);
    put("/counts", head.counts, false);
    put("/cost", head.cost, true);
    put("/curves",
        {{"displacement", "m", "of the top of the wall"}, {"force", "N", "horizontal load"}},
        true);
    put_attribute(file, "/walls/inputs", "missing", missing);
    put_parts(file, head);
}

StoreHead stored_head(const hdf5::File& file)
{
    check_layout(file);
    StoreHead head;
    head.configuration = only_text(file, "/configuration");
    head.identity = only_text(file, "/identity");
    const auto stress = numbers<double>(file, "/levels/vertical_stress");
    const auto samples = numbers<std::uint32_t>(file, "/levels/samples");
    const auto slower = is_stored(file, kLevelSlower)
                            ? numbers<std::uint32_t>(file, kLevelSlower)
                            : std::vector<std::uint32_t>(stress.size(), 1);
    const auto turned = is_stored(file, kLevelTurned)
                            ? numbers<std::uint32_t>(file, kLevelTurned)
                            : std::vector<std::uint32_t>(stress.size(), 0);
    if (stress.size() != samples.size() || stress.size() != slower.size() ||
        stress.size() != turned.size())
        damaged(file.path, "there is not a number of samples for each level");
    for (std::size_t i = 0; i < stress.size(); ++i)
        head.levels.push_back({stress[i], samples[i], slower[i], turned[i] != 0});
    head.design_sizes = numbers<std::uint32_t>(file, "/design_sizes");
    head.seed = hdf5::number_attribute(file, "/", "seed");
    const auto small = [&](const char* name) {
        return static_cast<std::uint32_t>(hdf5::number_attribute(file, "/", name, UINT32_MAX));
    };
    head.shard = small("shard");
    head.shards = small("shards");
    head.sessions = sessions(file);
    head.inputs = structs<Column>(file, kInput);
    head.responses = columns(file, "/responses");
    head.counts = columns(file, "/counts");
    head.cost = columns(file, "/cost");
    read_parts(file, head);
    head.single_precision_curves =
        Dataset(file, "/curves/force").value_bytes() == sizeof(float);
    try {
        check_head(head);
    } catch (const std::invalid_argument& error) {
        damaged(file.path, error.what());
    }
    if ((head.design_sizes.empty() ? 0 : head.design_sizes.back()) != most_samples(head.levels))
        damaged(file.path, "/design_sizes does not end with the largest number of samples");
    return head;
}

} // namespace app
