#include "app/store/dimensions.hpp"

#include "app/store/hdf5/hdf5_dataset.hpp"

#include <hdf5_hl.h>

#include <cstdio>
#include <string>
#include <vector>

namespace app {
namespace {

using hdf5::Handle;

/// A dimension that is not a variable: netCDF-4 knows it by this name, with the length in ten
/// digits.
std::string netcdf_name(std::uint64_t length)
{
    char text[80];
    std::snprintf(text, sizeof text,
                  "This is a netCDF dimension but not a netCDF variable.%10llu",
                  static_cast<unsigned long long>(length));
    return text;
}

class Dimensions {
  public:
    explicit Dimensions(const hdf5::File& file) : file_(file) {}

    void add(const std::string& name, std::uint64_t length)
    {
        const std::vector<hsize_t> sizes = {length};
        const Handle space = file_.owned(H5Screate_simple(1, sizes.data(), nullptr), H5Sclose,
                                         "name a dimension of");
        const Handle list =
            file_.owned(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "name a dimension of");
        file_.checked(H5Pset_obj_track_times(list.get(), false), "name a dimension of");
        const Handle scale =
            file_.owned(H5Dcreate2(file_.id.get(), name.c_str(), H5T_IEEE_F32BE, space.get(),
                                   H5P_DEFAULT, list.get(), H5P_DEFAULT),
                        H5Dclose, "name a dimension of");
        file_.checked(H5DSset_scale(scale.get(), netcdf_name(length).c_str()),
                      "name a dimension of");
    }

    /// Names of the axes of a dataset, in order.
    void give(const std::string& dataset, const std::vector<std::string>& names)
    {
        const Handle to = file_.owned(H5Dopen2(file_.id.get(), dataset.c_str(), H5P_DEFAULT),
                                      H5Dclose, "find " + dataset + " in");
        for (unsigned axis = 0; axis < names.size(); ++axis) {
            const Handle scale =
                file_.owned(H5Dopen2(file_.id.get(), names[axis].c_str(), H5P_DEFAULT),
                            H5Dclose, "name a dimension of");
            file_.checked(H5DSattach_scale(to.get(), scale.get(), axis), "name a dimension of");
        }
    }

  private:
    const hdf5::File& file_;
};

void give_columns(Dimensions& dimensions, const std::string& group,
                  const std::vector<Column>& columns)
{
    for (const Column& c : columns) dimensions.give(group + "/" + c.name, {"/wall"});
}

void give_piers(Dimensions& d, const StorePiers& piers)
{
    if (piers.places.empty()) return;
    d.add("/pier", piers.places.size());
    for (const char* name :
         {"/piers/from", "/piers/to", "/piers/bottom", "/piers/top", "/piers/storey"})
        d.give(name, {"/pier"});
    for (const Column& c : piers.facts) d.give("/piers/" + c.name, {"/wall", "/pier"});
    for (const char* name : {"/piers/movement", "/piers/shear"})
        d.give(name, {"/curve_point", "/pier"});
}

void give_spandrels(Dimensions& d, const StorePiers& spandrels)
{
    if (spandrels.places.empty()) return;
    d.add("/spandrel", spandrels.places.size());
    for (const char* name :
         {"/spandrels/from", "/spandrels/to", "/spandrels/bottom", "/spandrels/top"})
        d.give(name, {"/spandrel"});
    for (const Column& c : spandrels.facts)
        d.give("/spandrels/" + c.name, {"/wall", "/spandrel"});
}

} // namespace

void put_dimensions(const hdf5::File& file, const StoreHead& head, std::uint64_t walls,
                    std::uint64_t points)
{
    Dimensions d(file);
    d.add("/wall", walls);
    d.add("/input", head.inputs.size());
    d.add("/curve_end", walls + 1);
    d.add("/curve_point", points);
    d.add("/stress_level", head.levels.size());
    d.add("/session", head.sessions.size());
    d.add("/design_growth", head.design_sizes.size());
    d.add("/text", 1);
    for (const char* name : {"/configuration", "/identity"}) d.give(name, {"/text"});
    d.give("/design_sizes", {"/design_growth"});
    for (const char* name : {"/levels/vertical_stress", "/levels/samples", "/levels/slower"})
        d.give(name, {"/stress_level"});
    if (has_turned(head)) d.give("/levels/turned", {"/stress_level"});
    for (const char* name :
         {"program_version", "machine", "build", "settings", "started", "solver_revision"})
        d.give(std::string("/sessions/") + name, {"/session"});
    for (const char* name : {"/walls/level", "/walls/sample", "/walls/status", "/walls/reason"})
        d.give(name, {"/wall"});
    for (const char* name : {"/walls/input_name", "/walls/input_unit", "/walls/input_meaning"})
        d.give(name, {"/input"});
    d.give("/walls/inputs", {"/wall", "/input"});
    give_columns(d, "/responses", head.responses);
    give_columns(d, "/counts", head.counts);
    give_columns(d, "/cost", head.cost);
    d.give("/curves/offset", {"/curve_end"});
    for (const char* name : {"/curves/displacement", "/curves/force"})
        d.give(name, {"/curve_point"});
    give_piers(d, head.piers);
    give_spandrels(d, head.spandrels);
}

} // namespace app
