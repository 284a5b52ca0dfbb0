#pragma once
/// The datasets of FILE.h5 with one row per wall or per point of a curve, listed once for writing
/// (C = ColumnWriter) and reading (C = ColumnReader). docs/store.md describes them.

#include "app/store/store_column.hpp"
#include "app/store/store_head.hpp"
#include "app/store/store_reader.hpp"

#include <string>
#include <vector>

namespace app::hdf5 {

template <class C> struct StudyColumns {
    C level, sample, status, reason, inputs, offset;
    std::vector<C> responses, counts, cost;
    std::vector<C> curve; ///< displacement, force, then StoreHead::curve_columns
};

/// Names of the columns of the curve, all of them.
[[nodiscard]] std::vector<Column> all_curve_columns(const StoreHead& head);

/// `make(name, shape)` makes one column. `reason` is text_type(size.reason_bytes).
template <class C, class Make>
[[nodiscard]] StudyColumns<C> study_columns(const StoreHead& head, const StoreSize& size,
                                            hid_t reason, const Make& make)
{
    const std::uint64_t n = size.walls;
    const auto plain = [&](const char* name, hid_t file_type, hid_t memory_type,
                           std::uint64_t rows) {
        return make(std::string(name), Shape{file_type, memory_type, rows});
    };
    const auto list = [&](const char* group, const std::vector<Column>& columns,
                          hid_t file_type, hid_t memory_type, std::uint64_t rows) {
        std::vector<C> made;
        for (const Column& column : columns)
            made.push_back(make(group + column.name, Shape{file_type, memory_type, rows}));
        return made;
    };
    const hid_t f64 = H5T_IEEE_F64LE, i64 = H5T_STD_I64LE;
    const hid_t curve = head.single_precision_curves ? H5T_IEEE_F32LE : f64;
    return {plain("/walls/level", H5T_STD_U32LE, H5T_NATIVE_UINT32, n),
            plain("/walls/sample", H5T_STD_U32LE, H5T_NATIVE_UINT32, n),
            plain("/walls/status", H5T_STD_I32LE, H5T_NATIVE_INT32, n),
            plain("/walls/reason", reason, reason, n),
            make("/walls/inputs", Shape{f64, H5T_NATIVE_DOUBLE, n, head.inputs.size(), true}),
            plain("/curves/offset", H5T_STD_U64LE, H5T_NATIVE_UINT64, n + 1),
            list("/responses/", head.responses, f64, H5T_NATIVE_DOUBLE, n),
            list("/counts/", head.counts, i64, H5T_NATIVE_INT64, n),
            list("/cost/", head.cost, f64, H5T_NATIVE_DOUBLE, n),
            list("/curves/", all_curve_columns(head), curve, H5T_NATIVE_DOUBLE, size.points)};
}

} // namespace app::hdf5
