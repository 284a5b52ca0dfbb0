#pragma once
/// A command line as it was understood.

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace app {

struct Verb;

/// Part `index` (from 0) of a study that is divided into `count` parts.
struct Shard {
    int index = 0, count = 1;
    bool every = false; ///< all parts, given as "*/N"
};

struct Command {
    const Verb* verb = nullptr;
    std::vector<std::string> words;     ///< all words after the verb
    std::string study;                  ///< the first of them: the file that is read
    std::string out;                    ///< output directory or file; it may not exist yet
    std::vector<std::string> overrides; ///< section.key=value, in order
    int threads = 1;                    ///< >= 1
    bool quiet = false;                 ///< no progress is shown
    bool verbose = false;               ///< tables are printed in full
    std::optional<int> sample;          ///< one wall of a study, >= 0
    bool mean_wall = false;             ///< the wall in which each random value is its mean
    std::string level; ///< the vertical stress as written; empty: the study has only one
    Shard shard;
    std::string script;                ///< a job array is written to this file, nothing is run
    bool rerun_failed = false;         ///< failed walls are run again
    bool report = false;               ///< tables and page follow the study
    std::vector<std::string> beside;   ///< measured curves that pictures show
    bool film = false;                 ///< a moving picture of each wall that is pushed
    std::string video;                 ///< the same as this GIF or WebM; empty: none
    bool partial = false;              ///< shards are merged although walls are missing
    std::vector<std::string> drift;    ///< columns of a table
    std::vector<std::string> censored; ///< of a table: for all drifts, or one for each
    std::string group;                 ///< column of a table; empty: none
    /// Columns of a table of counts; of walls that were shaken the first is a measure. Empty:
    /// none.
    std::string intensity, of, state;
    std::vector<std::string> failed;   ///< columns of a table of counts
    std::string hazard;                ///< a table of a hazard curve; empty: none
    std::vector<std::string> measures; ///< of a record, beside those that are always shown
    std::string unit;                  ///< of the values of a record; empty: as the file says
    std::string address = "127.0.0.1"; ///< at which a server listens
    int port = 4242;                   ///< of a server; 0: any free one
    std::vector<std::string> hosts; ///< further names of a server, and of pages that may ask it
    std::vector<std::string> inputs;  ///< keys that a server takes; empty: the random variables
    std::vector<std::string> predict; ///< further stresses, of a calibration
    std::vector<std::string> responses;         ///< that a server gives; empty: the peak force
    std::optional<int> walls;                   ///< number of walls that a page shows, >= 0
    std::string method;                         ///< by which stones are found; empty: the best
    std::string title;                          ///< of a page; empty: that of the study
    std::map<std::string, std::string> answers; ///< of a new study, by option: "length", "3 m"
};

} // namespace app
