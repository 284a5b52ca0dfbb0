#include "app/store/store_row_codec.hpp"

#include "app/store/store_bytes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace app {

namespace {

/// Numbers of a wall beside its curve.
std::uint64_t numbers_of(const StoreHead& head)
{
    return head.inputs.size() + head.responses.size() + head.counts.size() + head.cost.size();
}

RowSummary take_summary(ByteDecoder& from)
{
    RowSummary summary;
    summary.key.level = from.value<std::uint32_t>();
    summary.key.sample = from.value<std::uint32_t>();
    summary.status = from.value<std::int32_t>();
    summary.reason_bytes = from.value<std::uint32_t>();
    summary.points = from.value<std::uint64_t>();
    return summary;
}

void put_curve_column(std::string& bytes, std::vector<double> values, bool single)
{
    if (single)
        for (double& value : values) value = static_cast<double>(static_cast<float>(value));
    put_all(bytes, values);
}

/// At most kMaxReason bytes, cut between two characters of UTF-8.
std::string_view cut_reason(std::string_view reason)
{
    if (reason.size() <= kMaxReason) return reason;
    std::size_t n = kMaxReason;
    while (n > 0 && (static_cast<unsigned char>(reason[n]) & 0xC0u) == 0x80u) --n;
    return reason.substr(0, n);
}

void check_curve(const StoreHead& head, const WallCurve& curve, const std::string& name)
{
    std::vector<const std::vector<double>*> columns{&curve.displacement, &curve.force};
    for (const std::vector<double>& column : curve.further) columns.push_back(&column);
    if (columns.size() != 2 + head.curve_columns.size())
        throw std::invalid_argument(name + ": the curve must have " +
                                    std::to_string(2 + head.curve_columns.size()) +
                                    " columns, has " + std::to_string(columns.size()));
    constexpr double largest = std::numeric_limits<float>::max();
    for (const std::vector<double>* column : columns) {
        if (column->size() != curve.displacement.size())
            throw std::invalid_argument(name + ": columns of the curve must be equally long");
        if (head.single_precision_curves && std::ranges::any_of(*column, [](double v) {
                return std::isfinite(v) && std::abs(v) > largest;
            }))
            throw std::invalid_argument(name +
                                        ": a value of the curve exceeds single precision");
    }
}

} // namespace

void encode_row(const StoreHead& head, const WallRow& row, std::string& bytes)
{
    put(bytes, row.key.level);
    put(bytes, row.key.sample);
    put(bytes, row.status);
    const std::string_view reason = cut_reason(row.reason);
    put(bytes, static_cast<std::uint32_t>(reason.size()));
    put(bytes, static_cast<std::uint64_t>(row.curve.displacement.size()));
    bytes += reason;
    put_all(bytes, row.inputs);
    put_all(bytes, row.responses);
    put_all(bytes, row.counts);
    put_all(bytes, row.cost);
    put_curve_column(bytes, row.curve.displacement, head.single_precision_curves);
    put_curve_column(bytes, row.curve.force, head.single_precision_curves);
    for (const std::vector<double>& column : row.curve.further)
        put_curve_column(bytes, column, head.single_precision_curves);
}

RowSummary decode_summary(const StoreHead& head, std::string_view bytes,
                          const std::string& file)
{
    ByteDecoder from(bytes, file);
    const RowSummary summary = take_summary(from);
    const std::uint64_t columns = 2 + head.curve_columns.size();
    if (summary.reason_bytes > kMaxReason || summary.points > bytes.size()) from.fail();
    from.take(summary.reason_bytes + 8 * numbers_of(head) + 8 * columns * summary.points);
    from.end();
    if (summary.key.level >= head.levels.size() ||
        summary.key.sample >= head.levels[summary.key.level].samples)
        from.fail();
    return summary;
}

WallRow decode_row(const StoreHead& head, std::string_view bytes, const std::string& file)
{
    const RowSummary summary = decode_summary(head, bytes, file);
    ByteDecoder from(bytes, file);
    static_cast<void>(take_summary(from));
    WallRow row;
    row.key = summary.key;
    row.status = summary.status;
    row.reason = std::string(from.take(summary.reason_bytes));
    row.inputs = from.values<double>(head.inputs.size());
    row.responses = from.values<double>(head.responses.size());
    row.counts = from.values<std::int64_t>(head.counts.size());
    row.cost = from.values<double>(head.cost.size());
    row.curve.displacement = from.values<double>(summary.points);
    row.curve.force = from.values<double>(summary.points);
    for (std::size_t k = 0; k < head.curve_columns.size(); ++k)
        row.curve.further.push_back(from.values<double>(summary.points));
    return row;
}

void check_row(const StoreHead& head, const WallRow& row)
{
    const std::string name = wall_name(row.key);
    const auto require = [&name](bool good, const std::string& what) {
        if (!good) throw std::invalid_argument(name + ": " + what);
    };
    require(row.key.level < head.levels.size() &&
                row.key.sample < head.levels[row.key.level].samples,
            "is not a wall of this study");
    require(row.status != std::numeric_limits<std::int32_t>::min(),
            "this status has another use");
    require(row.reason.find('\0') == std::string::npos, "the reason must not hold a NUL");
    const auto length = [&](const char* list, std::size_t is, std::size_t wanted) {
        require(is == wanted, std::string(list) + " must be " + std::to_string(wanted) +
                                  " numbers, are " + std::to_string(is));
    };
    length("inputs", row.inputs.size(), head.inputs.size());
    length("responses", row.responses.size(), head.responses.size());
    length("counts", row.counts.size(), head.counts.size());
    length("cost", row.cost.size(), head.cost.size());
    check_curve(head, row.curve, name);
}

} // namespace app
