/// Every case of bad input, through the library: the exact message.

#include "app/bad_input/cases.hpp"
#include "app/input/command_line.hpp"
#include "app/input/prepared_study.hpp"
#include "app/input/study/study_file.hpp"
#include "app/input/study_reading.hpp"
#include "app/text/config_error.hpp"

#include <catch2/catch.hpp>

#include <string>

namespace {

/// Complaint on reading a study text; empty: nothing.
std::string complaint(const std::string& text)
{
    try {
        (void)app::prepare(app::read_study(app::parse_study_text("study.ini", text))).study;
    } catch (const app::ConfigError& error) {
        return error.what();
    }
    return {};
}

} // namespace

TEST_CASE("bad input: the study that every case spoils is good", "[app][bad_input]")
{
    CHECK(complaint(std::string(bad_input::kGoodStudy)) == "");
}

TEST_CASE("bad input: a fault in a study file is named by line and key, with a remedy",
          "[app][bad_input]")
{
    for (const bad_input::BadStudy& bad : bad_input::bad_studies()) {
        INFO(bad.fault);
        CHECK(complaint(bad_input::text_of(bad)) == bad.message);
    }
}
