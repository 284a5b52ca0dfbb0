#include "app/report/report_assets.hpp"
#include "app/report/report_page.hpp"
#include "scenes/base64_text.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <string>

#include <zlib.h>

using Json = nlohmann::ordered_json;

TEST_CASE("report page: no text ends the script that it is in, and it reads back the same",
          "[app][report_page]")
{
    const std::string text = "</script><!-- <b> & \" ' \\ \xe2\x80\xa8 ]]>";
    const std::string json = app::script_json({{"a</b", text}});
    CHECK(json.find('<') == std::string::npos);
    CHECK(Json::parse(json)["a</b"] == text);
}

TEST_CASE("report page: numbers that are none are null; bytes that are no text do not stop it",
          "[app][report_page]")
{
    const double infinity = std::numeric_limits<double>::infinity();
    CHECK(app::script_json({{"x", {std::nan(""), infinity, -infinity, 1.5}}}) ==
          R"({"x":[null,null,null,1.5]})");
    CHECK(Json::parse(app::script_json({{"x", "a\xff"}}))["x"] == "a\xef\xbf\xbd");
}

TEST_CASE("report page: packed data unpack to the same JSON, without a NaN, in less room",
          "[app][report_page]")
{
    Json data = {{"x", std::nan("")}, {"text", Json::array()}};
    for (int i = 0; i < 200; ++i) data["text"].push_back("</script> the same again");
    const std::string text = app::packed(data);
    CHECK(text.find('<') == std::string::npos);
    CHECK(text.size() < 600);
    const auto bytes = scenes::bytes_of_base64(text);
    std::string back(100'000, ' ');
    uLongf size = back.size();
    REQUIRE(uncompress(reinterpret_cast<Bytef*>(back.data()), &size, bytes.data(),
                       bytes.size()) == Z_OK);
    const Json read = Json::parse(back.substr(0, size));
    CHECK(read["x"].is_null());
    CHECK(read["text"] == data["text"]);
}

TEST_CASE("report page: a title is text, whatever it is", "[app][report_page]")
{
    CHECK(app::html_text(R"(a<b>&"c")") == "a&lt;b&gt;&amp;&quot;c&quot;");
    const std::string page =
        app::report_page("<script>alert(1)</script>", Json::object(), Json::object());
    CHECK(page.find("<script>alert") == std::string::npos);
    CHECK(page.find("<title>&lt;script&gt;") != std::string::npos);
}

TEST_CASE("report page: every place of the page is filled, data are not read as places",
          "[app][report_page]")
{
    const std::string page = app::report_page("t", Json::object(), {{"x", "{{title}}"}});
    CHECK(page.find("{\"x\":\"{{title}}\"}") != std::string::npos);
    CHECK(page.find("{{style}}") == std::string::npos);
    CHECK(page.find("{{data}}") == std::string::npos);
    CHECK(page.ends_with("</html>\n"));
}

TEST_CASE("report page: the page asks for nothing from elsewhere and keeps the licence of its "
          "charts",
          "[app][report_page]")
{
    const std::string page = app::report_page("t", Json::object(), Json::object());
    for (const char* const asking : {"src=\"", "<link", "@import", "url(", "fetch(", "XMLHttp"})
        CHECK(page.find(asking) == std::string::npos);
    CHECK(page.find("default-src 'none'") != std::string::npos);
    CHECK(page.find("The MIT License") != std::string::npos);
    CHECK(page.find("Copyright (c)") != std::string::npos);
}

TEST_CASE("report page: modules become one script", "[app][report_page]")
{
    const std::string script(app::report_script());
    CHECK(script.find("\nimport ") == std::string::npos);
    CHECK(script.find("\nexport ") == std::string::npos);
    CHECK(script.find("</script") == std::string::npos);
    CHECK(std::string(app::chart_script()).find("</script") == std::string::npos);
    CHECK(script.find("function readFilm") != std::string::npos);
}
