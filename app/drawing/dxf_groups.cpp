#include "app/drawing/dxf_groups.hpp"

#include "app/drawing/outlines/drawing_file.hpp"
#include "app/text/words.hpp"

#include <cmath>
#include <string>

namespace app {
std::string_view DxfGroups::take_line()
{
    const std::size_t end = text_.find('\n', at_);
    const std::string_view line =
        text_.substr(at_, end == std::string_view::npos ? end : end - at_);
    at_ = end == std::string_view::npos ? text_.size() : end + 1;
    ++line_;
    return trimmed(line);
}

std::optional<DxfGroup> DxfGroups::next()
{
    last_ = at_;
    if (at_ >= text_.size()) return {};
    const std::string_view code = take_line();
    if (code.empty() && at_ >= text_.size()) return {}; // an empty line at the end
    const std::optional<double> number = read_number(code);
    if (!number || *number != std::floor(*number) || std::abs(*number) > 2000) {
        refuse(frame_, line_,
               "\"" + readable_name(code.substr(0, 40)) +
                   "\" is not a group code of DXF; save the drawing as ASCII DXF again");
    }
    if (at_ >= text_.size())
        refuse(frame_, line_, "the file ends within a pair; save the drawing as DXF again");
    const std::string_view value = take_line();
    return DxfGroup{static_cast<int>(*number), value, line_};
}

void DxfGroups::step_back()
{
    at_ = last_;
    line_ -= 2;
}

void DxfGroups::go_to(Place place)
{
    at_ = last_ = place.at;
    line_ = place.line;
}

double dxf_number(const DrawingFrame& frame, const DxfGroup& group)
{
    const std::optional<double> value = read_number(group.value);
    if (!value) {
        refuse(frame, group.line,
               "\"" + readable_name(group.value.substr(0, 40)) +
                   "\" is not a number; save the drawing as DXF again");
    }
    return *value;
}

int dxf_integer(const DrawingFrame& frame, const DxfGroup& group)
{
    const double value = dxf_number(frame, group);
    if (value != std::floor(value) || std::abs(value) > 1e9) {
        refuse(frame, group.line,
               "\"" + readable_name(group.value.substr(0, 40)) +
                   "\" is not a whole number; save the drawing as DXF again");
    }
    return static_cast<int>(value);
}

} // namespace app
