#include "ground/record_texts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace record_texts {
namespace {

template <class... Values> std::string printed(const char* format, Values... values)
{
    char text[256];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

std::string rows(const std::vector<double>& values, const char* format, int per_line,
                 const char* end = "\n")
{
    std::string text;
    for (std::size_t i = 0; i < values.size(); ++i) {
        text += printed(format, values[i]);
        if ((i + 1) % static_cast<std::size_t>(per_line) == 0 || i + 1 == values.size())
            text += end;
    }
    return text;
}

double peak_of(const std::vector<double>& values)
{
    double peak = 0.0;
    for (const double v : values) peak = std::abs(v) > std::abs(peak) ? v : peak;
    return peak;
}

std::string lines(int n, const std::string& line)
{
    std::string text;
    for (int i = 0; i < n; ++i) text += line + '\n';
    return text;
}

} // namespace

std::vector<double> wave(int n, double peak)
{
    std::vector<double> a;
    for (int i = 0; i < n; ++i)
        a.push_back(std::round(1e3 * peak * std::sin(0.7 * i) * std::exp(-3.0 * i / n)) / 1e3);
    return a;
}

std::string at2(int n)
{
    return "PEER NGA STRONG MOTION DATABASE RECORD\nSomewhere, 1/2/2003\nACCELERATION TIME "
           "SERIES IN UNITS OF G\n" +
           printed("NPTS=%7d, DT=   .0050 SEC,\n", n) + rows(wave(n, 0.5), "%15.7E", 5);
}

std::string old_at2(int n)
{
    return "PACIFIC ENGINEERING\nSOMEWHERE\nACCELERATION TIME HISTORY IN UNITS OF G\n" +
           printed("%6d   0.00500  NPTS, DT\n", n) + rows(wave(n, 0.5), "%15.7E", 5, "\r\n");
}

std::string columns(int n)
{
    std::string text = "# time [s], acceleration [m/s2]\n";
    const std::vector<double> a = wave(n, 3.0);
    for (int i = 0; i < n; ++i)
        text += printed("%.4f, %.3f\n", 0.0025 * i, a[static_cast<std::size_t>(i)]);
    return text;
}

std::string v1(int n)
{
    const std::vector<double> a = wave(n, 4.0);
    std::string text =
        "UNCORRECTED ACCELEROGRAM DATA              PROCESSED: 05/24/2011\n" +
        lines(5, "SOMEWHERE") + "CHAN  1: EW       (STA CHN:  1)\n" + lines(3, "SOMEWHERE") +
        printed("NO. OF POINTS = %6d  RECORD LENGTH =%7.3f SEC\n", n, 0.01 * n) +
        printed("UNITS OF UNCOR ACCEL ARE SEC AND G/10.     MAX  = %6.3f G, AT  30.160 SEC\n",
                peak_of(a) / 10.0) +
        "RMS ACCEL OF COMPLETE RECORD = 0.106 G\n" + lines(7, "    1    1    1    3") +
        lines(7, "     0.039     0.700");
    for (int i = 0; i < n; ++i)
        text += printed("%7.3f%7.3f", 0.01 * i, a[static_cast<std::size_t>(i)]) +
                ((i + 1) % 5 == 0 || i + 1 == n ? "\n" : "");
    return text + "/&  ----------  END OF DATA FOR CHANNEL 1  ----------\n";
}

std::string v2(int n)
{
    std::string text;
    for (int c = 1; c <= 2; ++c) {
        std::vector<double> a = wave(n, 120.0 * c);
        text +=
            "CORRECTED ACCELEROGRAM   12345-S1234       CHAN  1:  90 DEG     FROM\nUNCORRECTED "
            "ACCELEROGRAM DATA\n" +
            lines(5, "SOMEWHERE") + printed("CHAN  %d:  %d DEG\n", c, 90 * c) +
            lines(9, "INSTR PERIOD =  .0407 SEC") +
            printed("PEAK ACCELERATION =  %8.3f    CM/SEC/SEC  AT   10.940   SEC.\n",
                    peak_of(a)) +
            lines(7, "SOMEWHERE") + lines(20, "    1    2    3") +
            printed(
                "%5d POINTS OF ACCEL DATA EQUALLY SPACED AT  .020 SEC.  (UNITS: CM/SEC/SEC)\n",
                n) +
            rows(a, "%10.3f", 8, "\r\n") +
            printed("%5d POINTS OF VELOC DATA EQUALLY SPACED AT  .020 SEC.  (UNITS: CM/SEC)\n",
                    n) +
            rows(a, "%10.3f", 8, "\r\n") + "/&  ----------  END OF DATA\r\n";
    }
    return text;
}

std::string v2a(int n)
{
    std::string text;
    for (int c = 1; c <= 2; ++c) {
        const std::vector<double> a = wave(n, 900.0 * c);
        text +=
            "Corrected accelerogram 1 GNS Science\n" + lines(8, "Somewhere") +
            printed("Number of points  %d    Duration %.2f sec\n", n, 0.02 * (n - 1)) +
            "Instrument corrected data at 0.020 sec intervals\nBand-pass\n" +
            printed("Component N%d0E  Longitudinal Accelerometer Axis\n", c) +
            printed("Acceleration:  peak %8.1f mm/s/s at  48.14 sec     rms    292.2 mm/s/s\n",
                    peak_of(a)) +
            "Velocity:      peak  -298.49 mm/s\nDisplacement:  peak   99.407 mm\n" +
            lines(3, "    2016      11") +
            printed("   65536     250     250%8d%8d%8d       0       0       2   20000\n", n, n,
                    n) +
            lines(6, "     1.0     2.0") + rows(a, "%8.1f", 10) + rows(a, "%8.1f", 10) +
            rows(a, "%8.1f", 10);
    }
    return text;
}

std::string smc(int n)
{
    const std::vector<double> a = wave(n, 80.0);
    std::string text =
        "2 CORRECTED ACCELEROGRAM\n*\nA1\n  1989\nMoment Mag=      7.1\nstation = Somewhere "
        "component=    133\n" +
        printed("epicentral dist =     63.0       pk     = %8.1f\n", peak_of(a)) +
        lines(4, "*") +
        "    -32768      1989       291         0         4         0    -32768      4225\n" +
        "         1         3    -32768    -32768        90       133       101         2\n" +
        printed("%10d", n) +
        "    -32768    -32768    -32768    -32768    -32768    -32768    -32768\n" +
        lines(3, "    -32768    -32768    -32768    -32768    -32768    -32768    -32768    "
                 "-32768") +
        "  0.1700000E+39  0.2000000E+03  0.3703700E+02 -0.1218830E+03  0.1800000E+02\n" +
        lines(9,
              "  0.1700000E+39  0.1700000E+39  0.1700000E+39  0.1700000E+39  0.1700000E+39") +
        lines(2, "|");
    for (std::size_t i = 0; i < a.size(); ++i) { // 1.2714E+1: no blank between
        int e =
            a[i] == 0.0 ? 0 : static_cast<int>(std::floor(std::log10(std::abs(a[i])) + 1e-9));
        text += printed("%7.4f", a[i] / std::pow(10.0, e)) + printed("E%+d", e) +
                ((i + 1) % 8 == 0 || i + 1 == a.size() ? "\n" : "");
    }
    return text;
}

std::string esm(int n)
{
    const std::vector<double> a = wave(n, 50.0);
    return "EVENT_NAME: SOMEWHERE\n" + lines(20, "KEY: ") + "SAMPLING_INTERVAL_S: 0.005000\n" +
           printed("NDATA: %d\n", n) + "STREAM: HNE\nUNITS: cm/s^2\n" +
           printed("PGA_CM/S^2: %.6f\n", peak_of(a)) + "DATA_TYPE: ACCELERATION\nUSER5: \n" +
           rows(a, "%.6f", 1);
}

std::string cosmos(int n)
{
    const std::vector<double> a = wave(n, 50.0);
    return "Corrected acceleration    (Format v01.20 with 13 text lines)\n" +
           lines(9, "Somewhere") +
           printed(
               "Processed:2019-03-03 05:46:55 GMT, UNKN, Max = %8.3f cm/sec2 at   76.215 sec\n",
               peak_of(a)) +
           lines(2, "Somewhere") +
           " 100 Integer-header values follow on  10 lines, Format= (10I8)\n" +
           lines(10, "       2       1       4     120       1    -999    -999      11    -999 "
                     "   -999") +
           " 100 Real-header values follow on  20 lines, Format= (5F15.6)\n" +
           lines(
               12,
               "    -999.000000    -999.000000    -999.000000    -999.000000    -999.000000") +
           "    -999.000000       5.000000     210.000000      -6.851512      76.215000\n" +
           lines(
               7,
               "    -999.000000    -999.000000    -999.000000    -999.000000    -999.000000") +
           "   1 Comment line(s) follow, each starting with a \"|\":\n|\n" +
           printed(
               "%8d acceleration pts, approx  210 secs, units=cm/sec2(04),Format=(1E15.6)\n",
               n) +
           rows(a, "%15.6e", 1) + "End-of-data\n";
}

namespace {

constexpr double kGalOfCount = 2000.0 / 8388608.0;

std::vector<int> knet_counts(int n)
{
    constexpr int kZero = -123456;
    std::vector<int> counts;
    for (const double a : wave(n, 120.0))
        counts.push_back(kZero + static_cast<int>(std::lround(a / kGalOfCount)));
    return counts;
}

} // namespace

std::vector<double> knet_wave(int n)
{
    std::vector<double> a;
    double mean = 0.0;
    for (const int c : knet_counts(n)) {
        a.push_back(c * kGalOfCount);
        mean += a.back() / n;
    }
    for (double& v : a) v -= mean;
    return a;
}

std::string knet(int n)
{
    std::string text =
        "Origin Time       2004/10/23 17:56:00\nLat.              37.292\n"
        "Long.             138.867\nDepth. (km)       13\nMag.              6.8\n"
        "Station Code      XXX001\nStation Lat.      37.3000\nStation Long.     138.8000\n"
        "Station Height(m) 50\nRecord Time       2004/10/23 17:56:15\n"
        "Sampling Freq(Hz) 100Hz\n" +
        printed("Duration Time(s)  %g\n", 0.01 * n) +
        "Dir.              E-W\nScale Factor      2000(gal)/8388608\n" +
        printed("Max. Acc. (gal)   %.3f\n", std::abs(peak_of(knet_wave(n)))) +
        "Last Correction   2004/10/23 17:56:00\nMemo.             \n";
    const std::vector<int> counts = knet_counts(n);
    for (std::size_t i = 0; i < counts.size(); ++i)
        text += printed("%9d", counts[i]) +
                ((i + 1) % 8 == 0 || i + 1 == counts.size() ? "\n" : "");
    return text;
}

std::string usgs(int n)
{
    const std::vector<double> a = wave(n, 50.0);
    std::string text;
    for (const char* const type : {"AC", "VL"})
        text += std::string(" SOMEWHERE\n YEAR=1987 JULIAN DAY=274 COMPONENT=  90\n "
                            "SAMPLES/SEC=200 FILTER TYPE=BUTTERWORTH  DATA TYPE=") +
                type + "\n" +
                printed(" NO OF POINTS=%6d, UNITS=CM/SEC**2, CM/SEC, AND CM\n", n) +
                rows(a, "%8.3f", 10, "\r\n");
    return text;
}

std::vector<Sample> all(int n)
{
    constexpr double kG = 9.80665;
    return {{at2(n), "PEER AT2", kG, 1, wave(n, 0.5), 0.005},
            {old_at2(n), "PEER AT2", kG, 1, wave(n, 0.5), 0.005},
            {columns(n), "two columns", 1.0, 1, wave(n, 3.0), 0.0025},
            {v1(n), "CSMIP V1", 0.1 * kG, 1, wave(n, 4.0), 0.01},
            {v2(n), "CSMIP V2", 0.01, 2, wave(n, 120.0), 0.02},
            {v2a(n), "GeoNet V2A", 0.001, 2, wave(n, 900.0), 0.02},
            {smc(n), "USGS SMC", 0.01, 1, wave(n, 80.0), 0.005},
            {esm(n), "ESM ASCII", 0.01, 1, wave(n, 50.0), 0.005},
            {cosmos(n), "COSMOS V2c", 0.01, 1, wave(n, 50.0), 0.005},
            {knet(n), "K-NET ASCII", 0.01, 1, knet_wave(n), 0.01},
            {usgs(n), "USGS text", 0.01, 1, wave(n, 50.0), 0.005}};
}

} // namespace record_texts
