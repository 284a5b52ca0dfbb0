#include "app/report/report_bytes.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <zlib.h>

namespace {

std::string base64_of(const std::string& text)
{
    const std::vector<std::uint8_t> bytes(text.begin(), text.end());
    return app::base64(bytes);
}

/// Sums the bytes as the page does.
std::vector<int> sums(const std::vector<std::uint8_t>& bytes, std::size_t length, int order)
{
    const std::size_t n = bytes.size() / 2;
    std::vector<std::int16_t> v(n);
    for (std::size_t i = 0; i < n; ++i) {
        const int folded = bytes[i] | bytes[n + i] << 8;
        v[i] = static_cast<std::int16_t>(folded % 2 == 0 ? folded / 2 : -(folded + 1) / 2);
    }
    for (int pass = 0; pass < order; ++pass)
        for (std::size_t i = 0; i < n; ++i)
            if (i % length != 0) v[i] = static_cast<std::int16_t>(v[i] + v[i - 1]);
    return {v.begin(), v.end()};
}

} // namespace

TEST_CASE("report bytes: base64 gives the test vectors of RFC 4648", "[app][report_bytes]")
{
    CHECK(base64_of("").empty());
    CHECK(base64_of("f") == "Zg==");
    CHECK(base64_of("fo") == "Zm8=");
    CHECK(base64_of("foo") == "Zm9v");
    CHECK(base64_of("foob") == "Zm9vYg==");
    CHECK(base64_of("fooba") == "Zm9vYmE=");
    CHECK(base64_of("foobar") == "Zm9vYmFy");
    CHECK(base64_of("\xff\xef\xbe") == "/+++");
}

TEST_CASE("report bytes: what is deflated inflates to the same bytes", "[app][report_bytes]")
{
    std::vector<std::uint8_t> bytes;
    for (int i = 0; i < 10'000; ++i) bytes.push_back(static_cast<std::uint8_t>(i * i / 7));
    const std::vector<std::uint8_t> packed = app::deflated(bytes);
    std::vector<std::uint8_t> back(bytes.size());
    uLongf size = back.size();
    REQUIRE(uncompress(back.data(), &size, packed.data(), packed.size()) == Z_OK);
    CHECK(size == bytes.size());
    CHECK(back == bytes);
}

TEST_CASE("report bytes: numbers come back from differences to half a step",
          "[app][report_bytes]")
{
    const int order = GENERATE(0, 1, 2);
    constexpr std::size_t kLength = 40;
    constexpr double kStep = 1e-5;
    std::vector<double> x;
    for (std::size_t i = 0; i < 3 * kLength; ++i)
        x.push_back(0.3 * std::sin(1.7 * static_cast<double>(i * i)));
    const std::vector<int> back =
        sums(app::differences(x, kLength, kStep, order), kLength, order);
    REQUIRE(back.size() == x.size());
    for (std::size_t i = 0; i < x.size(); ++i)
        CHECK(std::abs(back[i] * kStep - x[i]) <= 0.5 * kStep * (1.0 + 1e-9));
}

TEST_CASE(
    "report bytes: of a straight line, second differences are zero but for the first two of "
    "each series",
    "[app][report_bytes]")
{
    std::vector<double> x;
    for (int series = 0; series < 2; ++series)
        for (int i = 0; i < 10; ++i) x.push_back(5.0 + 3.0 * i);
    const std::vector<std::uint8_t> bytes = app::differences(x, 10, 1.0, 2);
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (i % 10 > 1) CHECK(bytes[i] == 0);
        CHECK(bytes[x.size() + i] == 0);
    }
    CHECK(bytes[0] == 10); // 5, and then 3 - 5 = -2
    CHECK(bytes[1] == 3);
}

TEST_CASE("report bytes: what is too large stops at the end, what is no number is 0",
          "[app][report_bytes]")
{
    const double infinity = std::numeric_limits<double>::infinity();
    const std::vector<double> x = {1e9, -1e9, std::nan(""), infinity};
    CHECK(sums(app::differences(x, 4, 1.0, 0), 4, 0) == std::vector<int>{32767, -32767, 0, 0});
    CHECK_THROWS_AS(app::differences(x, 4, 0.0, 0), std::invalid_argument);
    CHECK_THROWS_AS(app::differences(x, 3, 1.0, 0), std::invalid_argument);
    CHECK_THROWS_AS(app::differences(x, 0, 1.0, 0), std::invalid_argument);
}
