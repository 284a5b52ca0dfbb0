#include "ground/motion_facts.hpp"
#include "ground/record.hpp"
#include "ground/record_error.hpp"
#include "ground/record_texts.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <string>

namespace {

using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

std::vector<ground::Record> read(const std::string& text,
                                 const ground::ReadOptions& options = {})
{
    return ground::parse_records("r.txt", text, options);
}

} // namespace

TEST_CASE("record: each format is told by its content and gives its values, step and unit",
          "[ground][record]")
{
    const int n = GENERATE(40, 203);
    for (const record_texts::Sample& s : record_texts::all(n)) {
        INFO(s.format);
        const auto records = read(s.text);
        REQUIRE(records.size() == s.components);
        CHECK(records[0].format == s.format);
        CHECK(records[0].motion.step == Approx(s.step).epsilon(1e-12));
        REQUIRE(records[0].motion.acceleration.size() == s.values.size());
        const double rounding = s.format == "USGS SMC"     ? 1e-4
                                : s.format == "GeoNet V2A" ? 1e-3
                                                           : 1e-9;
        for (std::size_t i = 0; i < s.values.size(); ++i)
            CHECK(records[0].motion.acceleration[i] ==
                  Approx(s.unit * s.values[i])
                      .epsilon(rounding)
                      .margin(s.format == "GeoNet V2A" ? 6e-5 : 1e-12));
    }
}

TEST_CASE("record: components have names", "[ground][record]")
{
    const auto two = read(record_texts::v2(40));
    CHECK(two[0].motion.name == "r 90 DEG");
    CHECK(two[1].component == "180 DEG");
    CHECK(read(record_texts::v2a(40))[1].component == "N20E");
}

TEST_CASE("record: K-NET counts are less their mean, and this is said", "[ground][record]")
{
    const std::string good = record_texts::knet(40);
    const auto r = ground::parse_records("XXX0010410231756.EW", good).front();
    CHECK(r.motion.name == "XXX0010410231756.EW"); // .NS and .UD are others
    CHECK(r.component == "E-W");
    CHECK(r.unit == "gal");
    CHECK(r.line == 18);
    REQUIRE(r.remarks.size() == 1);
    CHECK_THAT(r.remarks[0], StartsWith("the mean, -2") && Contains(" gal, was taken off"));
    REQUIRE(r.stated_peak.has_value());
    CHECK_THROWS_WITH(read(replaced(good, "2000(gal)", "4000(gal)")),
                      StartsWith("r.txt:15: the head states a peak of "));
    CHECK_THROWS_WITH(read(replaced(good, "/8388608", "")),
                      StartsWith("r.txt:14: no scale; it is written as in "));
    CHECK_THROWS_WITH(read(replaced(good, "(gal)/", "(um)/")),
                      StartsWith("r.txt:18: \"um\" is no unit of acceleration"));
    CHECK_THROWS_WITH(read(replaced(good, "(s)  0.4", "(s)  0.5")),
                      Contains("the file ends after 40 of 50 values"));
    CHECK_THROWS_WITH(read(replaced(good, "(s)  0.4", "(s)  0.3")),
                      Contains("more than the 30 values"));
    CHECK_THROWS_WITH(read(replaced(good, "100Hz", "Hz")),
                      StartsWith("r.txt:11: no frequency; it is written as in "));
    CHECK_THROWS_WITH(read(replaced(good, "Memo.", "")),
                      StartsWith("r.txt:1: the head has no line of \"Memo.\""));
}

TEST_CASE("record: values that touch each other are told apart", "[ground][record]")
{
    const auto r =
        read("IN UNITS OF CM/SEC/SEC\nNPTS= 4, DT= .01 SEC\n-1.5E+01-2.5-3.25E-1 4.\n");
    CHECK(r[0].motion.acceleration[0] == Approx(-0.15));
    CHECK(r[0].motion.acceleration[1] == Approx(-0.025));
    CHECK(r[0].motion.acceleration[2] == Approx(-0.00325));
    CHECK(r[0].motion.acceleration[3] == Approx(0.04));
}

TEST_CASE("record: exponents with Fortran's D are numbers", "[ground][record]")
{
    std::string text = record_texts::at2(40);
    std::ranges::replace(text.begin() + static_cast<std::ptrdiff_t>(text.find("SEC,")),
                         text.end(), 'E', 'D'); // SEC becomes SDC
    text = replaced(replaced(text, "SDC", "SEC"), " .0050", " 5.D-3");
    REQUIRE(text.find("E-") == std::string::npos);
    const auto e = read(record_texts::at2(40)), d = read(text);
    CHECK(d[0].motion.step == e[0].motion.step);
    CHECK(d[0].motion.acceleration == e[0].motion.acceleration);
    CHECK_THROWS_WITH(read("IN UNITS OF G\nNPTS= 3, DT= .01\n0.1 1D2D3 0.1\n"),
                      Contains("is no number"));
}

TEST_CASE("record: fewer or more values than stated are refused with the line",
          "[ground][record]")
{
    const std::string good = record_texts::at2(40);
    CHECK_THROWS_WITH(read(good.substr(0, good.size() - 17)),
                      StartsWith("r.txt:12: the file ends after 39 of 40 values"));
    CHECK_THROWS_WITH(read(replaced(good, "NPTS=     40", "NPTS=     35")),
                      Contains("more than the 35 values that line 4 states"));
    CHECK_THROWS_WITH(read(replaced(good, "NPTS=     40", "NPTS=     38")),
                      Contains("more than the 38 values"));
    CHECK_THROWS_WITH(read(replaced(good, "NPTS=     40", "NPTS=  -1000")),
                      Contains("is no number of points"));
    CHECK_THROWS_WITH(read(replaced(good, ".0050 SEC", "-.005 SEC")),
                      StartsWith("r.txt:4: a time step of -0.005 s"));
    CHECK_THROWS_WITH(read(replaced(good, "DT=   .0050 SEC", "DT=   none")),
                      Contains("no time step; write it"));
    CHECK_THROWS_WITH(read(replaced(record_texts::esm(40), "NDATA: 40", "NDATA: 39")),
                      Contains("more than the 39 values"));
}

TEST_CASE("record: a value that is no finite number is refused with the line",
          "[ground][record]")
{
    std::string good = record_texts::columns(40);
    CHECK_THROWS_WITH(read(replaced(good, "0.0025, ", "0.0025, nan ")),
                      StartsWith("r.txt:3: 3 values in place of two"));
    CHECK_THROWS_WITH(read("0.00 0.1\n0.01 nan\n0.02 0.1\n"),
                      StartsWith("r.txt:2: \"nan\" is no finite number"));
    CHECK_THROWS_WITH(read("IN UNITS OF G\nNPTS= 3, DT= .01\n0.1 NaN 0.1\n"),
                      StartsWith("r.txt:3: \"NaN\" is not finite"));
    CHECK_THROWS_WITH(read("IN UNITS OF G\nNPTS= 3, DT= .01\n0.1 **** 0.1\n"),
                      StartsWith("r.txt:3: \"****\" is no number"));
}

TEST_CASE("record: gaps, doubled and unequal times are refused at their line",
          "[ground][record]")
{
    CHECK_THROWS_WITH(
        read("0.000 0.1\n0.010 0.1\n0.030 0.1\n0.040 .1\n0.050 .1\n"),
        StartsWith("r.txt:3: a step of 0.02 s before 0.03 s, where 0.01 s is usual: a gap"));
    CHECK_THROWS_WITH(read("0.00 0.1\n0.01 0.1\n0.01 0.1\n"),
                      StartsWith("r.txt:3: the time 0.01 s does not come after"));
    CHECK_THROWS_WITH(read("0 0.1\n1 0.1\n2 0.1\n"),
                      Contains("a time step of 1 s is out of range") && Contains("in ms to s"));
    // 0.0025 s rounded to milliseconds
    std::string rounded;
    for (int i = 0; i < 400; ++i) {
        char row[40];
        std::snprintf(row, sizeof row, "%.3f 0.1\n", 0.0025 * i);
        rounded += row;
    }
    CHECK(read(rounded)[0].motion.step == Approx(0.0025).epsilon(2e-3));
}

TEST_CASE("record: columns of another quantity or unit are refused, not read in g",
          "[ground][record]")
{
    const std::string rows = "0.00 0.1\n0.01 0.2\n0.02 -0.3\n";
    const auto refused = [&](const std::string& head, const std::string& why,
                             const ground::ReadOptions& options = {}) {
        INFO(head);
        CHECK_THROWS_WITH(read("Station A\n" + head + "\n\n" + rows, options),
                          StartsWith("r.txt:2: ") && Contains(why));
    };
    refused("time [s], velocity [cm/s]", "no acceleration; give the record of the accel");
    refused("Time (s)  Displacement (cm)", "no acceleration");
    refused("Ground velocity, m/s", "no acceleration");
    refused("# Displacement (CM)", "no acceleration");
    refused("time [ms]; acc [m/s2]", "the times are in ms; convert them to s");
    refused("time [s]; acc [mg]", "\"mg\" is no unit of acceleration; use g, m/s2");
    refused("time [ms]; acc [mg]", "the times are in ms", {"g"});
    refused("t [ms]; acc [g]", "the times are in ms");
    CHECK(read("time [s]; acc [mg]\n" + rows, {"m/s2"})[0].motion.acceleration[1] == 0.2);
    // titles, and names that say nothing of units
    for (const std::string head :
         {"Velocity pulse, station (Foo)", "Velocity pulse in town, M 6",
          "Velocity of 2 m/s in its pulse, acc",
          "Acceleration time series (channel 1), min -0.3, max 0.2", "time [s], acc, min -0.3",
          "time [s], accel", "Time (sec) Acc (g)", "time, acceleration", "time [s]"}) {
        INFO(head);
        CHECK(read(head + "\n" + rows)[0].motion.acceleration[1] == Approx(0.2 * 9.80665));
    }
    CHECK_THROWS_WITH(read("t;a\n0,00;0,1\n0,01;0,2\n"),
                      StartsWith("r.txt:2: decimal commas; write points"));
    CHECK_THROWS_WITH(read("t a\n0 0\n0,01 0,2\n"), StartsWith("r.txt:3: decimal commas"));
    CHECK_THROWS_WITH(read("acc [g], time [s]\n.3,0\n.1,.01\n.2,.02\n"),
                      StartsWith("r.txt:2: the second column grows as a time does"));
    refused("Zeit [ms]; a [m/s2]", "the times are in ms");
    refused("time_ms, acc_g", "the times are in ms");
    refused("time [s], acc [%g]", "\"%g\" is no unit of acceleration");
    CHECK_THROWS_WITH(read("1 2 3 4 5 6 7 8\n1 2 3 4 5 6 7 8\n"),
                      StartsWith("r.txt:1: 8 columns") && Contains("a line such as \"NPTS="));
}

TEST_CASE("record: units are read, told or refused, never guessed where they matter",
          "[ground][record]")
{
    const std::string columns = "0.00 1\n0.01 2\n0.02 -3\n";
    CHECK(read(columns)[0].motion.acceleration[2] == Approx(-3 * 9.80665));
    CHECK_THAT(read(columns)[0].remarks.at(0), Contains("read in g"));
    CHECK(read("time (s)  acc (cm/s2)\n" + columns)[0].motion.acceleration[2] == Approx(-0.03));
    // the names of the columns count before other lines; a letter is no unit
    for (const std::string head : {"% time [s], acc [m/s2]\n# PGA = 0.35 g", "time_s,acc_m_s2",
                                   "Acceleration\ns, m/s2", "Station G\ntime [s], a [m/s2]"}) {
        INFO(head);
        CHECK(read(head + "\n" + columns)[0].motion.acceleration[2] == -3.0);
    }
    CHECK_THAT(read("Station G\n" + columns)[0].remarks.at(0), Contains("read in g"));
    CHECK(read("acc in m/s2\nNPTS= 2, DT= .01\n1 2\n")[0].motion.acceleration[1] == 2.0);
    CHECK_THROWS_WITH(read("Title\nNPTS= 2, DT= .01\n1 200\n"), Contains("too large for g"));
    // line ends of old spreadsheets, and quotes
    CHECK(read("\"time [s]\",\"acc [g]\"\r\"0.00\",\"1\"\r\"0.01\",\"2\"\r")[0].motion.step ==
          Approx(0.01));
    CHECK(read(columns, {"mm/s2"})[0].motion.acceleration[2] == Approx(-0.003));
    CHECK_THROWS_WITH(read("0.00 100\n0.01 200\n"), Contains("too large for g"));
    CHECK_THROWS_WITH(read(replaced(record_texts::at2(40), "UNITS OF G", "UNITS OF CM/SEC")),
                      Contains("\"cm/sec\" is no unit of acceleration"));
    CHECK_THAT(read(record_texts::esm(40), {"mm/s2"})[0].remarks.at(0),
               Contains("as told, where the file says cm/s^2"));
    CHECK(ground::acceleration_unit("CMS/SEC/SEC") == 0.01);
    CHECK(ground::acceleration_unit("cm/sec**2") == 0.01);
    CHECK(ground::acceleration_unit("m/s") == 0.0);
}

TEST_CASE("record: a unit that is not certain is refused, in every language",
          "[ground][record]")
{
    const std::string rows = "0.00 0.1\n0.01 0.2\n0.02 -0.3\n";
    const auto factor = [&](const std::string& head) {
        INFO(head);
        return read(head + "\n" + rows)[0].motion.acceleration[1] / 0.2;
    };
    const double g = 9.80665;
    // values of other quantities, names of stations, words of other languages
    CHECK(factor("time [s], acc [cm/s2] (converted from g)") == Approx(0.01));
    CHECK(factor("time [s], acc [m/s2], scaled to 0.3 g") == Approx(1.0));
    CHECK(factor("time s acc cm/s2 station G") == Approx(0.01));
    CHECK(factor("Zeit [s]; Beschleunigung [m s-2]") == Approx(1.0));
    CHECK(factor("t [s], a [m\xC2\xB7s\xE2\x81\xBB\xC2\xB2]") == Approx(1.0)); // m·s⁻²
    CHECK(factor("Zeit [s], Beschleunigung [m/s\xB2]") == Approx(1.0));        // Latin-1
    CHECK(read("t [s], a [m/s\xB2]\n" + rows)[0].unit == "m/s2");
    CHECK(factor("t [s], a [cm.s-2]") == Approx(0.01));
    CHECK(factor("# PGA = 49.1 cm/s2\ntime, acc") == Approx(g));
    CHECK(factor("# 1 g = 9.81 m/s2\ntime, acc") == Approx(g));
    CHECK(factor("# accelerations in g (9.81 m/s2)") == Approx(g));
    CHECK(factor("# acceleration in m/s2\n# peak 0.05 g\ntime, acc") == Approx(1.0));
    CHECK(factor("# acceleration in m/s2\nStation G") == Approx(1.0));
    CHECK(factor("time [s], acc (in g)") == Approx(g));
    for (const std::string unit : {"% g", "% of g", "0.01 g", "1e-3 g", "milli g", "mg",
                                   "g/100", "ft/s2", "in/s2", "m/s-2"}) {
        INFO(unit);
        CHECK_THROWS_WITH(read("time [s], acc [" + unit + "]\n" + rows),
                          StartsWith("r.txt:1: \"" + unit + "\" is no unit of acceleration"));
        CHECK(read("time [s], acc [" + unit + "]\n" + rows, {"g"})[0].unit == "g");
    }
    for (const std::string head :
         {"Zeit (s);Geschwindigkeit (m/s)", "Geschwindigkeit (m/s)", "Zeit (s);Weg (mm)",
          "Tiempo (s), Velocidad (cm/s)", "t [s], v [m s-1]", "Temps [s], D [m]",
          "# acceleration in % g", "# acceleration in mg", "time, a_mg"}) {
        INFO(head);
        CHECK_THROWS_WITH(read(head + "\n" + rows), Contains(" is no unit of acceleration"));
    }
    CHECK_THROWS_WITH(read("# recorded in cm/s2, here in g\n# \ntime, acc\n" + rows),
                      StartsWith("r.txt:1: two units of acceleration, \"cm/s2\" and \"g\""));
    // g in words above values that are none in g
    const std::string large = "0.00 10\n0.01 20\n";
    CHECK_THROWS_WITH(read("# as recorded in g\n# \ntime, acc\n" + large),
                      StartsWith("r.txt:1: the unit seems to be g, and the values are too "));
    CHECK(read("time, acc [g]\n" + large)[0].motion.acceleration[1] == Approx(20 * g));
    CHECK_THROWS_WITH(read("units: \nNPTS= 2, DT= .01\n1 200\n"), Contains("too large for g"));
    CHECK_THROWS_WITH(read("A record\nVELOCITY TIME SERIES\nNPTS= 2, DT= .01\n1 2\n"),
                      StartsWith("r.txt:2: the values are no acceleration"));
}

TEST_CASE("record: heads in several lines, padded lines and rounded times are read",
          "[ground][record]")
{
    const auto two =
        read("UNITS OF G. FILTER POINTS: HP=0.1 Hz\nNPTS= 3\nDT= .005 SEC\n1 2 3\n");
    CHECK(two[0].motion.step == 0.005);
    CHECK(two[0].motion.acceleration[2] == Approx(3 * 9.80665));
    CHECK(read("IN UNITS OF G\nDT= .005\nNPTS= 3\n1 2 3\n")[0].motion.step == 0.005);
    std::string padded = record_texts::v1(40);
    for (std::size_t at = padded.find("  0.000  ");
         (at = padded.find('\n', at)) < padded.size();)
        padded.insert(at, std::string(10, ' ')), at += 11;
    CHECK(read(padded)[0].motion.acceleration ==
          read(record_texts::v1(40))[0].motion.acceleration);
    std::string rounded = "time [s], acc [m/s2]\n";
    for (int i = 0; i < 400; ++i) {
        char row[40];
        std::snprintf(row, sizeof row, "%.2f 0.1\n", 0.25 * i * 0.4 / 4);
        rounded += row;
    }
    CHECK(read(rounded)[0].motion.step == 0.025);
}

TEST_CASE("record: a value that stands for a missing one is refused", "[ground][record]")
{
    const std::string head = "time [s], acc [cm/s2]\n";
    CHECK_THROWS_WITH(read(head + "0.00 1.5\n0.01 -999\n0.02 2.5\n"),
                      StartsWith("r.txt:2: value 2 is -999, which stands for a missing one"));
    CHECK_THROWS_WITH(read(head + "0.00 -999\n0.01 1\n0.02 2.5\n"),
                      Contains("value 1 is -999"));
    CHECK_THROWS_WITH(read(head + "0.00 1\n0.01 2.5\n0.02 -9999\n"),
                      Contains("value 3 is -9999"));
    CHECK(read(head + "0.00 -990\n0.01 -999\n0.02 -980\n")[0].motion.acceleration.size() == 3);
}

TEST_CASE("record: a step that contradicts its head is refused", "[ground][record]")
{
    const std::string v2 = replaced(record_texts::v2(40), "PEAK ACC",
                                    "AT EQUALLY-SPACED INTERVALS OF .020 SEC.\nPEAK ACC");
    CHECK(read(v2)[0].motion.step == 0.02);
    CHECK_THROWS_WITH(read(replaced(v2, "OF .020", "OF .010")),
                      StartsWith("r.txt:18: a time step of 0.01 s, where line 47 has 0.02 s"));
    const std::string length =
        replaced(record_texts::v2(40), "PEAK ACC", "RECORD LENGTH = 0.84 SEC\nPEAK ACC");
    CHECK(read(length)[0].motion.step == 0.02); // cut when it was corrected
    CHECK_THROWS_WITH(read(replaced(length, "0.84", "0.40")),
                      StartsWith("r.txt:18: the head states a duration of 0.4 s"));
    CHECK_THROWS_WITH(read(replaced(record_texts::v1(40), "0.400", "0.800")),
                      StartsWith("r.txt:11: the head states a duration of 0.8 s"));
    CHECK_THROWS_WITH(read(replaced(record_texts::v2a(40), "at 0.020", "at 0.010")),
                      StartsWith("r.txt:10: the head states a duration of 0.78 s"));
}

TEST_CASE("record: a peak that is not the stated one is refused", "[ground][record]")
{
    CHECK_THROWS_WITH(read(replaced(record_texts::esm(40), "PGA_CM/S^2: ", "PGA_CM/S^2: 9")),
                      Contains("the head states a peak"));
    CHECK(read(record_texts::esm(40))[0].stated_peak.has_value());
    // a wrong step leaves the peak: the duration finds it
    const std::string lasting =
        replaced(record_texts::esm(40), "STREAM:", "DURATION_S: 0.195000\nSTREAM:");
    CHECK(read(lasting)[0].motion.step == 0.005);
    CHECK(read(replaced(lasting, "0.195", "0.200"))[0].motion.step == 0.005);
    CHECK_THROWS_WITH(read(replaced(lasting, "0.005000", "0.010000")),
                      StartsWith("r.txt:24: the head states a duration of 0.195 s, but the "
                                 "values have 0.39 s"));
}

TEST_CASE("record: empty, binary and unknown texts, columns of another number are refused",
          "[ground][record]")
{
    CHECK_THROWS_WITH(read(" \n\r\n"), StartsWith("r.txt: is empty"));
    CHECK_THROWS_WITH(read(std::string("NPTS= 3\0 4", 10)), StartsWith("r.txt: is binary"));
    CHECK_THROWS_WITH(read("\x89PNG\r\n"), StartsWith("r.txt: is in no format known here"));
    CHECK_THROWS_WITH(read("0.1\n0.2\n"), StartsWith("r.txt:1: one column and no time step"));
    CHECK_THROWS_WITH(read("0 1 2\n1 2 3\n"), StartsWith("r.txt:1: 3 columns"));
    CHECK_THROWS_WITH(ground::read_records("/"), Contains("is a directory"));
    CHECK_THROWS_WITH(ground::read_records("nowhere.at2"), Contains("cannot be read"));
}

TEST_CASE("record: a velocity that does not come to rest is found", "[ground][record]")
{
    const auto offset = read("0.00 0.1\n0.01 0.1\n0.02 0.1\n")[0].motion;
    CHECK_THAT(unfit_motion(motion_facts(offset)), Contains("100 % of the PGV"));
    CHECK_THROWS_AS(check_motion("r.txt", offset), ground::RecordError);
    CHECK_NOTHROW(check_motion("r.txt", offset, 1.0));
    CHECK(ground::unfit_motion(ground::motion_facts({"", 0.01, {0.0, 1.0, 0.0, -1.0, 0.0}}))
              .empty());
    CHECK_THAT(ground::unfit_motion(ground::motion_facts({"", 0.01, {0.0, 0.0}})),
               Contains("all accelerations are 0"));
}

TEST_CASE("record: a million samples take less than two seconds", "[ground][record]")
{
    const std::string text = record_texts::at2(1'000'000);
    const auto start = std::chrono::steady_clock::now();
    CHECK(read(text)[0].motion.acceleration.size() == 1'000'000);
    CHECK(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() <
          2.0);
}
