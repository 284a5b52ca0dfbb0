#pragma once
/// Changes of the objects of an HDF5 file, made by HDF5 itself: all checksums are right, as
/// those of a file that someone made on purpose.

#include "uq/designs/stream.hpp"

#include <hdf5.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace crafted {

/// Opens the file to write, and lets `change` work on it.
void change(const std::filesystem::path& file, const std::function<void(hid_t)>& change);

/// A dataset to come: zeros, or what `values` begins with, in the place of one that is there;
/// its attributes unit and meaning are kept.
struct NewDataset {
    std::vector<hsize_t> sizes; ///< none: a scalar
    hid_t type = -1;            ///< -1: that of the one before
    std::vector<hsize_t> chunk{};
    std::vector<char> values{};            ///< none: not written
    std::function<void(hid_t)> creation{}; ///< takes the property list of the dataset
};
void replace(hid_t file, const std::string& name, const NewDataset& by);

/// An attribute of `n` values of a type, all bytes `byte`, in the place of one that is there; n
/// = -1: one value.
void replace_attribute(hid_t file, const std::string& object, const std::string& name,
                       hid_t type, int n = -1, char byte = 'A');

/// Makes a soft or an external link of an object; the object is gone.
void link_to(hid_t file, const std::string& name, const std::string& target,
             const std::string& other_file = {});

/// One random change. @return which, for messages
std::string change_anything(const std::filesystem::path& file, uq::Stream& random);

} // namespace crafted
