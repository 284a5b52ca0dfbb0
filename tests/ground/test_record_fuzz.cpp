#include "ground/record.hpp"
#include "ground/record_error.hpp"
#include "ground/record_texts.hpp"
#include "uq/designs/stream.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace {

constexpr std::string_view kPieces[] = {
    "nan", "inf", "-",     ".",   "1e308", "1E-320", "99999999999",
    "\n",  "\t",  "NPTS=", "DT=", "\xff",  "E",      " POINTS OF ACC DATA",
    "/&",  "(",   "  "};

/// A piece put in, taken out, doubled, a line taken out, or bytes and digits turned into
/// others.
void mutate(std::string& text, uq::Stream& random)
{
    const std::size_t at = random.below(text.size() + 1);
    const std::size_t length = std::min<std::size_t>(text.size() - at, random.below(60));
    switch (random.below(6)) {
    case 0:
        text.insert(at, kPieces[random.below(std::size(kPieces))]);
        break;
    case 1:
        text.erase(at, length);
        break;
    case 2:
        text.insert(random.below(text.size() + 1), text.substr(at, length));
        break;
    case 3:
        text.erase(std::min(text.find('\n', at), text.size()), random.below(200));
        break;
    case 4:
        if (at < text.size()) text[at] = static_cast<char>(random.below(256));
        break;
    default:
        for (char& c : text)
            if (c >= '0' && c <= '9' && random.below(60) == 0)
                c = static_cast<char>('0' + random.below(10));
    }
}

} // namespace

TEST_CASE("record fuzz: two thousand broken records are read or refused with a place",
          "[ground][fuzz]")
{
    const std::vector<record_texts::Sample> originals = record_texts::all(90);
    int read = 0, refused = 0;
    for (std::uint64_t i = 0; i < 2000; ++i) {
        uq::Stream random(1, i, uq::Purpose::search);
        std::string text = originals[i % originals.size()].text;
        for (std::uint64_t n = random.below(3) + 1; n > 0; --n) mutate(text, random);
        try {
            for (const ground::Record& r : ground::parse_records("fuzz.txt", text)) {
                CHECK(r.motion.step > 0.0);
                CHECK(std::ranges::all_of(r.motion.acceleration,
                                          [](double a) { return std::isfinite(a); }));
            }
            ++read;
        } catch (const ground::RecordError& e) {
            INFO(e.what());
            CHECK(std::string_view(e.what()).starts_with("fuzz.txt:"));
            CHECK(std::string_view(e.what()).size() < 400);
            ++refused;
        }
    }
    CHECK(read > 100);
    CHECK(refused > 500);
}
