#include "app/store/continued_head.hpp"

#include "app/store/hdf5/store_error.hpp"

#include <algorithm>
#include <set>
#include <sstream>
#include <vector>

namespace app {

namespace {

std::vector<std::string> lines_of(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

/// A line as a message shows it: outlines of a drawing, or what a stranger wrote, can be
/// megabytes.
std::string shortened(const std::string& line)
{
    constexpr std::size_t most = 300;
    if (line.size() <= most) return line;
    std::size_t n = most;
    while (n > 0 && (static_cast<unsigned char>(line[n]) & 0xC0u) == 0x80u) --n; // UTF-8
    return line.substr(0, n) + " ...";
}

[[noreturn]] void refuse(const std::string& file, const std::string& why)
{
    throw BadStoredStudy(file + ": " + why +
                         "\nUse another output file, or the inputs of this one.");
}

std::string in_megapascals(double stress)
{
    std::ostringstream text;
    text << stress / 1e6 << " MPa";
    return text.str();
}

void check_revision(const std::string& file, const StoreHead& stored, const StoreHead& wanted)
{
    const std::string before = solver_revision(stored.identity),
                      now = solver_revision(wanted.identity);
    if (before == now) return;
    const std::string version =
        stored.sessions.empty() ? ""
                                : " (version " + stored.sessions.front().program_version + ")";
    throw BadStoredStudy(
        file + ": was begun by " + revision_words(before) + version + ". This program has " +
        revision_words(now) +
        ", which gives other numbers for the same walls.\nFinish the file with "
        "the version that began it, or begin a new one with another --out.");
}

void check_levels(const std::string& file, const StoreHead& stored, const StoreHead& wanted)
{
    for (std::size_t k = 0; k < stored.levels.size(); ++k) {
        const StoreLevel& before = stored.levels[k];
        const std::uint32_t audited = k < wanted.levels.size() ? wanted.levels[k].samples : 0;
        if (before.slower > 1 && audited < before.samples)
            refuse(file, "has " + std::to_string(before.samples) +
                             " walls of each stress pushed again more slowly, only " +
                             std::to_string(audited) + " are wanted (uq.audit)");
        if (before.turned && (k >= wanted.levels.size() || !wanted.levels[k].turned))
            refuse(file, "has walls that were pushed both ways; write load.direction = both");
        if (k >= wanted.levels.size())
            refuse(file, "has " + std::to_string(stored.levels.size()) +
                             " levels of vertical stress, but " +
                             std::to_string(wanted.levels.size()) + " are wanted");
        if (!(wanted.levels[k].vertical_stress == before.vertical_stress))
            refuse(file, "has walls at " + in_megapascals(before.vertical_stress) +
                             ", and another vertical stress is wanted there");
        if (wanted.levels[k].turned != before.turned)
            refuse(file, "has an audit and walls that were pushed one way; both directions "
                         "cannot be added behind an audit");
        if (wanted.levels[k].slower != before.slower)
            refuse(file, "has walls at " + in_megapascals(before.vertical_stress) + " pushed " +
                             std::to_string(before.slower) + " times slower, not " +
                             std::to_string(wanted.levels[k].slower));
        if (wanted.levels[k].samples < before.samples)
            refuse(file, "has " + std::to_string(before.samples) + " samples at " +
                             in_megapascals(before.vertical_stress) + ", only " +
                             std::to_string(wanted.levels[k].samples) + " are wanted");
    }
}

} // namespace

std::string text_difference(const std::string& before, const std::string& after,
                            std::size_t most)
{
    const std::vector<std::string> a = lines_of(before), b = lines_of(after);
    const std::multiset<std::string> in_a(a.begin(), a.end()), in_b(b.begin(), b.end());
    std::vector<std::string> differing;
    for (const std::string& line : a)
        if (in_a.count(line) > in_b.count(line)) differing.push_back("- " + line);
    for (const std::string& line : b)
        if (in_b.count(line) > in_a.count(line)) differing.push_back("+ " + line);
    if (differing.empty() && before != after)
        differing.push_back("  the same lines in another order or with other line ends");
    std::string text;
    for (std::size_t k = 0; k < std::min(most, differing.size()); ++k)
        text += shortened(differing[k]) + "\n";
    if (differing.size() > most)
        text += "and " + std::to_string(differing.size() - most) + " more lines\n";
    return text;
}

std::string solver_revision(const std::string& identity)
{
    for (const std::string& line : lines_of(identity))
        if (line.starts_with(kRevisionKey)) return line.substr(kRevisionKey.size());
    return "";
}

std::string revision_words(const std::string& revision)
{
    return (revision.empty() ? "an earlier revision" : "revision " + shortened(revision)) +
           " of the solver";
}

std::string study_text(const StoreHead& head)
{
    std::string text = head.identity + "\nseed = " + std::to_string(head.seed) +
                       "\nshard = " + std::to_string(head.shard + 1) + " of " +
                       std::to_string(head.shards) + "\n";
    const auto add = [&text](const char* list, const std::vector<Column>& columns) {
        for (const Column& c : columns)
            text += std::string(list) + " " + c.name + " [" + c.unit + "] " + c.meaning + "\n";
    };
    add("input", head.inputs);
    add("response", head.responses);
    add("count", head.counts);
    add("cost", head.cost);
    const auto add_parts = [&](const char* name, const StorePiers& parts) {
        add(name, parts.facts);
        for (const StorePier& p : parts.places)
            text += std::string(name) + " at " + std::to_string(p.from) + " to " +
                    std::to_string(p.to) + " m, " + std::to_string(p.bottom) + " to " +
                    std::to_string(p.top) + " m\n";
    };
    add_parts("pier", head.piers);
    add_parts("spandrel", head.spandrels);
    return text;
}

std::string study_difference(const StoreHead& before, const StoreHead& after)
{
    const std::string inputs = text_difference(before.identity, after.identity);
    return inputs.empty() ? text_difference(study_text(before), study_text(after)) : inputs;
}

StoreHead continued_head(const std::string& file, const StoreHead& stored,
                         const StoreHead& wanted)
{
    check_revision(file, stored, wanted);
    StoreHead head = wanted;
    if (stored.spandrels.places.empty()) head.spandrels = {}; // of a version before
    const std::string why = study_difference(stored, head);
    if (!why.empty())
        refuse(file, "has other inputs (-: in the file, +: in this study):\n" + why);
    check_levels(file, stored, wanted);

    head.design_sizes = stored.design_sizes;
    const std::uint32_t largest = most_samples(wanted.levels);
    if (largest > (head.design_sizes.empty() ? 0 : head.design_sizes.back()))
        head.design_sizes.push_back(largest);
    head.sessions = stored.sessions;
    head.sessions.insert(head.sessions.end(), wanted.sessions.begin(), wanted.sessions.end());
    head.single_precision_curves = stored.single_precision_curves;
    return head;
}

} // namespace app
