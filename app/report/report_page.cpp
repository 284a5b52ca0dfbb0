#include "app/report/report_page.hpp"

#include "app/output/picture/markup.hpp"
#include "app/report/report_assets.hpp"
#include "app/report/report_bytes.hpp"
#include "app/text/json_text.hpp"

#include <cstdint>
#include <stdexcept>
#include <vector>

namespace app {

std::string html_text(std::string_view text)
{
    constexpr Replacement kHtml[] = {
        {"&", "&amp;"}, {"<", "&lt;"}, {">", "&gt;"}, {"\"", "&quot;"}};
    return replaced(text, kHtml);
}

std::string script_json(const nlohmann::ordered_json& data)
{
    // "<" only occurs inside strings of JSON; written so, "</script>" and "<!--" cannot occur
    constexpr Replacement kLess[] = {{"<", "\\u003c"}};
    return replaced(text_of(data), kLess);
}

std::string packed(const nlohmann::ordered_json& data)
{
    const std::string text = script_json(data);
    const std::vector<std::uint8_t> bytes(text.begin(), text.end());
    return base64(deflated(bytes));
}

std::string report_page(const std::string& title, const nlohmann::ordered_json& data,
                        const nlohmann::ordered_json& films)
{
    const auto content = [&](std::string_view name) -> std::string {
        if (name == "mark") return std::string(kPageMark);
        if (name == "title") return html_text(title);
        if (name == "style") return std::string(report_style());
        if (name == "chart_style") return std::string(chart_style());
        if (name == "chart_script") return std::string(chart_script());
        if (name == "script") return std::string(report_script());
        if (name == "data") return packed(data);
        if (name == "films") return script_json(films);
        throw std::logic_error("report page: no content for " + std::string(name));
    };
    std::string_view rest = report_page_html();
    std::string page;
    for (std::size_t at = rest.find("{{"); at != rest.npos; at = rest.find("{{")) {
        const std::size_t end = rest.find("}}", at);
        page += rest.substr(0, at);
        page += content(rest.substr(at + 2, end - at - 2));
        rest.remove_prefix(end + 2);
    }
    page += rest;
    return page;
}

} // namespace app
