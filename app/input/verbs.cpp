#include "app/input/verbs.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace app {
namespace {

using Options = std::string_view;

constexpr std::array<Options, 6> kPush = {"out", "set", "threads", "quiet", "sample", "level"};
constexpr std::array<Options, 8> kStudy = {"out",   "set",   "threads",      "quiet",
                                           "shard", "slurm", "rerun-failed", "report"};
constexpr std::array<Options, 3> kSample = {"out", "set", "quiet"};
constexpr std::array<Options, 5> kReliability = {"out", "set", "threads", "quiet", "level"};
constexpr std::array<Options, 4> kReport = {"out", "walls", "threads", "quiet"};
constexpr std::array<Options, 6> kFragility = {"out",   "set",      "quiet",
                                               "drift", "censored", "group"};
constexpr std::array<Options, 2> kCurves = {"out", "quiet"};
constexpr std::array<Options, 2> kMerge = {"partial", "quiet"};

constexpr std::size_t kMany = 1'000'000;

constexpr std::array kRules = {
    VerbRule{Verb::push, "push", "STUDY.ini",
             "push one wall: capacity curve, summary, pictures", OutKind::folder, "", 1, 1,
             kPush, "drystone push configs/wall.ini"},
    VerbRule{Verb::study, "study", "STUDY.ini",
             "samples x stress levels into one file; goes on where it stopped", OutKind::file,
             ".h5", 1, 1, kStudy, "drystone study configs/quick.ini"},
    VerbRule{Verb::sample, "sample", "STUDY.ini", "the samples alone, as a table",
             OutKind::file, ".csv", 1, 1, kSample, "drystone sample configs/quick.ini"},
    VerbRule{Verb::reliability, "reliability", "STUDY.ini",
             "the probability that a response falls to a demand, and what it depends on",
             OutKind::folder, "", 1, 1, kReliability,
             "drystone reliability configs/reliability.ini"},
    VerbRule{Verb::fragility, "fragility", "FILE.h5|FILE.csv",
             "limit drifts, fragility curves, modes: of a study, or of a table of drifts",
             OutKind::folder, "", 1, 1, kFragility, "drystone fragility runs/quick.h5"},
    VerbRule{Verb::report, "report", "FILE.h5", "one page for a browser from a study's file",
             OutKind::file, ".html", 1, 1, kReport, "drystone report runs/quick.h5"},
    VerbRule{Verb::curves, "curves", "FILE.h5", "all capacity curves of a study as one table",
             OutKind::file, ".csv", 1, 1, kCurves, "drystone curves runs/quick.h5"},
    VerbRule{Verb::merge, "merge", "OUT.h5 SHARD.h5...", "shards of one study into one file",
             OutKind::first_word, "", 2, kMany, kMerge,
             "drystone merge runs/paper.h5 runs/paper_*.h5"},
};

} // namespace

std::span<const VerbRule> verb_rules() { return kRules; }

const VerbRule* find_verb(std::string_view name)
{
    for (const VerbRule& r : kRules)
        if (r.name == name) return &r;
    return nullptr;
}

const VerbRule& rule_of(Verb verb)
{
    for (const VerbRule& r : kRules)
        if (r.verb == verb) return r;
    throw std::invalid_argument("a verb without a rule");
}

bool takes(const VerbRule& rule, std::string_view option)
{
    return std::find(rule.options.begin(), rule.options.end(), option) != rule.options.end();
}

} // namespace app
