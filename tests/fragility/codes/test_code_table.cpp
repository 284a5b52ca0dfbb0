#include "fragility/codes/code_table.hpp"

#include "fragility/curve/limit_states.hpp"
#include "tests/fragility/curve_scenes.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <string>
#include <string_view>
#include <vector>

using namespace fragility;
using scenes::OwnedCurve;

namespace {

auto near(double value) { return Approx(value).epsilon(1e-14).margin(0.0); }

const CodeState& built_in(std::string_view code, std::string_view state)
{
    for (const CodeState& s : find_code(built_in_codes(), code)->states)
        if (s.name == state) return s;
    FAIL("no state " << state);
    throw;
}

/// A table of one code with these limit states.
std::vector<Code> table(const std::string& states)
{
    return read_code_table("{\"codes\": [\n{\"name\": \"mine\", \"title\": \"Mine\",\n"
                           "\"states\": [\n" +
                           states + "\n]}]}");
}

std::string state_text(const std::string& name, const std::string& rest)
{
    return R"({"name": ")" + name + R"(", "source": "here", )" + rest + "}";
}

/// The error of a table: "line: key: words".
std::string error_of(const std::string& text)
{
    try {
        static_cast<void>(read_code_table(text));
    } catch (const CodeTableError& bad) {
        return std::to_string(bad.line) + ": " + bad.key + ": " + bad.what();
    }
    return "no error";
}

} // namespace

TEST_CASE("code table: drift limits of the Italian code and of EN 1998-3 are the printed ones",
          "[fragility][code_table]")
{
    CHECK(drift_limit(built_in("ntc", "SLC"), "rocking", 2.0) == near(0.010));
    CHECK(drift_limit(built_in("ntc", "SLC"), "sliding", 2.0) == near(0.005));
    CHECK(drift_limit(built_in("ntc", "SLC"), "mixed", 2.0) == near(0.005));
    struct Printed {
        std::string_view code;
        double flexure, shear; // at SD
    };
    for (const Printed& p : {Printed{"ec8", 0.008, 0.004}, {"ec8_secondary", 0.012, 0.006}}) {
        const CodeState& nc = built_in(p.code, "NC");
        CHECK(0.75 * drift_limit(nc, "rocking", 1.0) == near(p.flexure));
        CHECK(0.75 * drift_limit(nc, "rocking", 2.5) == near(2.5 * p.flexure));
        CHECK(0.75 * drift_limit(nc, "sliding", 2.5) == near(p.shear));
        CHECK(built_in(p.code, "DL").part == CodePart::yield);
        CHECK(source_text(nc).find("compare with your copy") != std::string::npos);
    }
}

TEST_CASE("code table: every limit state has a source, and codes of which nothing is given say "
          "why",
          "[fragility][code_table]")
{
    int missing = 0;
    for (const Code& code : built_in_codes()) {
        INFO(code.name);
        for (const CodeState& s : code.states) CHECK_FALSE(s.source.empty());
        if (!code.states.empty()) continue;
        CHECK(code.missing.size() > 20);
        CHECK_THROWS_AS(read_limit_states(scenes::triangle(), code, {}), std::invalid_argument);
        ++missing;
    }
    CHECK(missing == 3);
    for (const std::string_view code : {"tbdy2018", "asce41"})
        CHECK(find_code(built_in_codes(), code)->states.empty());
}

TEST_CASE("code table: a limit state is read at what its rule says", "[fragility][code_table]")
{
    const OwnedCurve c = scenes::triangle(); // up to 10 at 1, down to 0 at 3
    const auto at = [&](const std::string& rest) {
        const auto codes = table(state_text("a", rest));
        const auto found = read_limit_states(c, codes.front(), {});
        return found.front().limit.displacement;
    };
    CHECK(at(R"("rule": "peak")") == near(1.0));
    CHECK(at(R"("rule": "1/2 peak")") == near(0.5));
    CHECK(at(R"("rule": "drop 0.5")") == near(2.0));
    CHECK(at(R"("rule": "rise 0.3")") == near(0.3));
    CHECK(at(R"("rule": "collapse")") == near(3.0));
    CHECK(at(R"("rule": "0.5 ultimate")") == near(0.7));
    const auto codes = table(state_text("LS", R"("rule": "2/3 CP")") + ",\n" +
                             state_text("CP", R"("rule": "drop 0.5")"));
    CHECK(read_limit_states(c, codes.front(), {}).front().limit.displacement ==
          near(4.0 / 3.0));
}

TEST_CASE("code table: a drift alone is reached where the curve gets so far, and beside a rule "
          "whichever comes first",
          "[fragility][code_table]")
{
    const OwnedCurve c = scenes::triangle();
    const auto read = [&](const std::string& rest, double cap) {
        const auto codes = table(state_text("a", rest));
        return read_limit_states(c, codes.front(), std::array{cap}).front().limit;
    };
    const std::string alone = R"("drift": {"other": "1 %"})",
                      both = R"("rule": "drop 0.5", "drift": {"other": "1 %"})";
    CHECK(read(alone, 0.7).displacement == near(0.7));
    CHECK(is_capped(read(alone, 0.7)));
    CHECK(is_censored(read(alone, 4.0)));
    CHECK_FALSE(is_defined(read(alone, 0.0))); // the code limits no drift of this mode
    CHECK(read(both, 1.2).displacement == near(1.2));
    CHECK(read(both, 2.5).displacement == near(2.0));
    CHECK_FALSE(is_capped(read(both, 2.5)));
}

TEST_CASE("code table: a mode that is not named takes the drift of all others, and without one "
          "has none",
          "[fragility][code_table]")
{
    const auto codes =
        table(state_text("a", R"("drift": {"times": "2", "sliding": "0.5 % H0/D"})"));
    const CodeState& s = codes.front().states.front();
    CHECK(drift_limit(s, "sliding", 3.0) == near(0.03));
    CHECK(drift_limit(s, "rocking", 3.0) == 0.0);
    CHECK(drift_text(s, 3.0) == "a drift of 1 % x H0/D = 3 % if the wall slides");
}

TEST_CASE("code table: a bad table is refused at its line, with what to write",
          "[fragility][code_table]")
{
    const auto bad = [](const std::string& states) {
        return error_of("{\"codes\": [\n{\"name\": \"mine\", \"title\": \"Mine\",\n"
                        "\"states\": [\n" +
                        states + "\n]}]}");
    };
    using Catch::StartsWith;
    CHECK_THAT(bad(state_text("LS", R"("rule": "3/4 CP")")),
               StartsWith("4: mine.LS.rule: \"CP\" is no limit state of this code"));
    CHECK_THAT(bad(state_text("LS", "\n\"rule\": \"yeld\"")),
               StartsWith("5: mine.LS.rule: \"yeld\" is not a rule; write yield,"));
    CHECK_THAT(bad(state_text("LS", "\"drift\": {\n\"rocking\": \"1\"}")),
               StartsWith("5: mine.LS.drift.rocking: \"1\" is no drift in (0, 100] %; write"));
    CHECK_THAT(bad(state_text("LS", R"("drift": {"roking": "1 %"})")),
               StartsWith("4: mine.LS.drift: \"roking\" is not a key here; known: times,"));
    CHECK_THAT(bad(state_text("LS", R"("drift": {})")),
               StartsWith("4: mine.LS.drift: names no"));
    CHECK_THAT(bad(state_text("LS", R"("drift": {"times": "-1", "other": "1 %"})")),
               StartsWith("4: mine.LS.drift.times: \"-1\" is no positive number; write"));
    CHECK_THAT(bad(state_text("LS", R"("article": "5")")),
               StartsWith("4: mine.LS: says neither rule nor drift; write"));
    CHECK_THAT(bad(R"({"name": "LS", "rule": "yield"})"),
               StartsWith("4: mine.LS.source: is missing; write where"));
    CHECK_THAT(bad(state_text("LS", R"("rule": 0.75)")),
               StartsWith("4: mine.LS.rule: is not a text; write it between"));
    CHECK_THAT(
        bad(state_text("LS", R"("rule": "drop 1.5")")),
        StartsWith("4: mine.LS.rule: \"1.5\" is no share of the peak; write \"drop 0.5"));
    CHECK_THAT(bad(state_text("LS", R"("rule": "yield")") + ",\n" +
                   state_text("LS", R"("rule": "peak")")),
               StartsWith("4: mine.LS: stands twice; keep one of them"));
    CHECK_THAT(bad(state_text("A", R"("rule": "1/2 B")") + ",\n" +
                   state_text("B", R"("rule": "1/2 C")") + ",\n" +
                   state_text("C", R"("rule": "yield")")),
               StartsWith("4: mine.A.rule: is a share of B, which is a share itself"));
    const std::string capped = R"("rule": "ultimate", "drift": {"other": "1 %"})";
    CHECK_THAT(bad(state_text("A", capped) + ",\n" + state_text("B", capped)),
               StartsWith("5: mine.B: is the second limit state of rule ultimate"));
    CHECK_THAT(bad(state_text("LS", R"("rule": "yield", "rule": "peak")")),
               StartsWith("4: rule: stands twice in one object; keep one"));
    CHECK_THAT(error_of("{\"codes\": [\n{\"name\": \"a b\", \"title\": \"x\"}]}"),
               StartsWith("2: a b: is no name of a code; write letters"));
    CHECK_THAT(error_of("{\"codes\": [\n{\"name\": \"user\", \"title\": \"x\"}]}"),
               StartsWith("2: user: is no name of a code"));
    CHECK_THAT(error_of("{\"codes\": [\n{\"name\": \"a\", \"title\": \"x\"}]}"),
               StartsWith("2: a.states: must be a list of objects; write"));
    CHECK_THAT(error_of("{\"codes\": [\n{\"name\": \"a\",,"), StartsWith("2: : is not JSON"));
    CHECK_THAT(error_of("{\"codes\": []}"), StartsWith("1: codes: must be a list of objects"));
    CHECK_THAT(error_of("[]"), StartsWith("1: : is no table of codes; write"));
    CHECK_THAT(error_of(""), StartsWith("1: : is not JSON"));
    CHECK_THAT(error_of(std::string(100, '[')), StartsWith("1: : is nested too deeply"));
}
