#include "app/input/prepared_study.hpp"
#include "app/input/study_reading.hpp"
#include "app/text/config_error.hpp"
#include "uq/designs/stream.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace {

std::string shipped(const std::string& name)
{
    std::ifstream in(std::string(DRYSTONE_SOURCE_DIR "/configs/") + name);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

std::vector<std::string> seeds()
{
    std::vector<std::string> all;
    for (const char* name : {"wall.ini", "levels.ini", "paper.ini", "correlated.ini",
                             "quick.ini", "reliability.ini"})
        all.push_back(shipped(name));
    return all;
}

constexpr std::string_view kPieces[] = {"(",
                                        ")",
                                        ",",
                                        "=",
                                        "#",
                                        "[",
                                        "]",
                                        "\n",
                                        " MPa",
                                        " deg",
                                        "normal(mean 1, cov 0.2)",
                                        "nan",
                                        "inf",
                                        "-1",
                                        "0",
                                        "1e308",
                                        "1e-308",
                                        "9999999999",
                                        "lognormal(",
                                        "empirical(",
                                        "from 1",
                                        "to 1",
                                        "\t",
                                        "\xff",
                                        std::string_view("\0", 1),
                                        "uq.",
                                        "mean mean",
                                        "0x10",
                                        "''",
                                        "\"",
                                        "..",
                                        "+",
                                        "e"};

/// A piece put in, taken out, doubled, swapped or turned into other bytes.
void mutate(std::string& text, uq::Stream& random)
{
    const std::size_t at = random.below(text.size() + 1);
    const std::size_t length = std::min<std::size_t>(text.size() - at, random.below(40));
    switch (random.below(6)) {
    case 0:
        text.insert(at, kPieces[random.below(std::size(kPieces))]);
        break;
    case 1:
        text.erase(at, length);
        break;
    case 2:
        text.insert(at, text.substr(at, length));
        break;
    case 3:
        text.insert(random.below(text.size() + 1), text.substr(at, length));
        break;
    case 4:
        if (at < text.size()) text[at] = static_cast<char>(random.below(256));
        break;
    default:
        for (char& c : text)
            if (c >= '0' && c <= '9' && random.below(30) == 0)
                c = static_cast<char>('0' + random.below(10));
    }
}

#ifdef NDEBUG
constexpr std::uint64_t kFiles = 10'000;
#else
constexpr std::uint64_t kFiles = 2'000; // sanitizers take ten times as long for each
#endif

} // namespace

TEST_CASE("study fuzz: ten thousand broken study files are read or refused with a place",
          "[app][fuzz]")
{
    const std::vector<std::string> originals = seeds();
    int read = 0, refused = 0;
    for (std::uint64_t i = 0; i < kFiles; ++i) {
        uq::Stream random(1, i, uq::Purpose::search);
        std::string text = originals[random.below(originals.size())];
        for (std::uint64_t n = random.below(4) + 1; n > 0; --n) mutate(text, random);
        try {
            const app::Study study =
                app::prepare(app::read_study(app::parse_study_text("fuzz.ini", text))).study;
            // what was read reads back
            (void)app::prepare(app::read_study(app::parse_study_text(
                                   "again.ini", app::effective_configuration(study))))
                .study;
            ++read;
        } catch (const app::ConfigError& e) {
            INFO(e.what());
            CHECK(std::string_view(e.what()).starts_with("fuzz.ini"));
            ++refused;
        }
    }
    CHECK(read > static_cast<int>(kFiles / 20));
    CHECK(refused > static_cast<int>(kFiles * 3 / 10));
}
