#include "app/reading/wall_numbers.hpp"

#include <algorithm>

namespace app {

std::string meaning(const WallNumber& n)
{
    std::string text(n.meaning);
    if (n.name != "outcome") return text;
    for (std::size_t i = 0; i < dem::kOutcomeNames.size(); ++i)
        text +=
            (i > 0 ? ", " : "") + std::to_string(i) + " " + std::string(dem::kOutcomeNames[i]);
    return text;
}

std::string words(const WallNumber& n)
{
    std::string text(n.name);
    std::ranges::replace(text, '_', ' ');
    return text;
}

std::string head_text(const WallNumber& n)
{
    const std::string head = n.head.empty() ? words(n) : std::string(n.head);
    return n.unit.name == "-" ? head : head + " [" + std::string(n.unit.name) + "]";
}

std::string summary_key(const WallNumber& n)
{
    std::string unit(n.unit.name);
    if (unit == "-") return std::string(n.name);
    if (unit == "%") unit = "percent";
    if (const auto slash = unit.find('/'); slash != std::string::npos)
        unit.replace(slash, 1, "_per_");
    return std::string(n.name) + "_" + unit;
}

namespace {

std::string row(const WallNumber& n)
{
    const char* const columns[] = {"", "`responses`", "`counts`"};
    const std::string shown = n.unit.name == n.unit.si ? "" : std::string(n.unit.name);
    return "| `" + std::string(n.name) + "` | " + std::string(n.unit.si) + " | " + shown +
           " | " + (n.reading != nullptr ? "reading" : "fact") + " | " +
           columns[static_cast<std::size_t>(n.kept)] + " | " + meaning(n) + " |\n";
}

} // namespace

std::string numbers_page()
{
    std::string judged, old, rows;
    for (std::size_t i = 0; i < kJudged; ++i)
        judged += (i > 0 ? ", `" : "`") + std::string(kWallNumbers[i].name) + "`";
    for (const WallNumber& n : kWallNumbers) {
        rows += row(n);
        if (!n.old_key.empty())
            old += (old.empty() ? "`" : ", `") + std::string(n.old_key) + "` is `" +
                   summary_key(n) + "`";
    }
    return "# Numbers of a wall\n\n"
           "Written by `drystone help numbers > docs/numbers.md`; a test keeps it current. The "
           "table is `app/reading/wall_numbers.hpp`.\n\n"
           "A *reading* follows the rules of `[fragility]`, a *fact* does not. The file of a "
           "study keeps numbers in SI, in the group named here ([store.md](store.md)); "
           "other readings are read off the curve whenever the file is opened.\n"
           "`drystone serve --response NAME` gives each number in SI ([serve.md](serve.md)). "
           "Python: `Results.responses`, `counts` and `readings()`, in SI. "
           "`summary.json` and tables have the unit *shown*; a key of `summary.json` ends with "
           "it: `peak_force_kN`, `ultimate_drift_percent`.\n"
           "`reliability.response`, `uq.stop` and `drystone surrogate --of` take " +
           judged +
           ".\n\n| name | SI | shown | kind | in the file | meaning |\n"
           "|---|---|---|---|---|---|\n" +
           rows + "\nUntil version 0.2 `summary.json` had other keys: " + old +
           ". `drystone compare` and Python's `Push.summary` know both.\n";
}

} // namespace app
