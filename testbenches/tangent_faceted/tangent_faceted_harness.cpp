// tangent: tangent-space set-up of a triangle's vertex: map, view vector and lights in texture space
// made by fixpath 0.1.0; seed 004 (US 7,843,463), with its mirroring rule and facets as printed and mended
//   frame=faceted mirror=handed basis=orthonormal lights=1 position_int_bits=4
//   position_frac_bits=11 uv_int_bits=2 uv_frac_bits=13 component_bits=16 guard_bits=2
//   vector_int_bits=1 vector_bits=16 out_frac_bits=14 norm_bits=18 dot_frac_bits=20
//   root_scheme=linear root_addr_bits=8 root_frac_bits=18 rounding=half-up period_ps=5000
//   stages=auto rom=block
// latency 21 cycles, interval 1 cycle; tables read on the clock
// absolute errors against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   t_angle: mean 6.44e-6 rad, largest seen 2.07e-5 rad at p0_x=10112 p0_y=-13087 p0_z=1777 p1_x=9474 p1_y=-12645 p1_z=1634 p2_x=9790 p2_y=-12829 p2_z=1369 uv0_u=-4264 uv0_v=10910 uv1_u=-4558 uv1_v=11772 uv2_u=-7611 uv2_v=11483 view_x=548 view_y=17311 view_z=12049 light0_x=1261 light0_y=5545 light0_z=2155
//   t_dot: mean 8.59e-6, largest seen 2.48e-5 at p0_x=1385 p0_y=12631 p0_z=-15491 p1_x=1521 p1_y=12473 p1_z=-15566 p2_x=1244 p2_y=12281 p2_z=-15784 uv0_u=-12255 uv0_v=18727 uv1_u=-10160 uv1_v=16132 uv2_u=-10611 uv2_v=14849 view_x=8012 view_y=-2458 view_z=2986 light0_x=-3484 light0_y=-3984 light0_z=-834
//   t_x: mean 4.38e-6, largest seen 2.05e-5 (1.3 ulp) at p0_x=8845 p0_y=-7357 p0_z=8918 p1_x=8982 p1_y=-7495 p1_z=8835 p2_x=8642 p2_y=-7486 p2_z=8723 uv0_u=7356 uv0_v=-1510 uv1_u=861 uv1_v=-14978 uv2_u=1714 uv2_v=-6705 view_x=21907 view_y=8320 view_z=3195 light0_x=-2207 light0_y=-1467 light0_z=9923
//   t_y: mean 4.38e-6, largest seen 1.98e-5 (1.3 ulp) at p0_x=-2916 p0_y=-2788 p0_z=-14527 p1_x=-2891 p1_y=-2951 p1_z=-14658 p2_x=-2936 p2_y=-2975 p2_z=-14683 uv0_u=13249 uv0_v=-3283 uv1_u=11297 uv1_v=-4440 uv2_u=10686 uv2_v=-3368 view_x=21236 view_y=-6071 view_z=19473 light0_x=-3237 light0_y=1137 light0_z=-6504
//   t_z: mean 4.37e-6, largest seen 2.11e-5 (1.4 ulp) at p0_x=582 p0_y=524 p0_z=6901 p1_x=726 p1_y=573 p1_z=7248 p2_x=617 p2_y=494 p2_z=6888 uv0_u=-4050 uv0_v=10840 uv1_u=-4012 uv1_v=10792 uv2_u=-4035 uv2_v=10797 view_x=4349 view_y=-3883 view_z=-2073 light0_x=3612 light0_y=-5188 light0_z=3156
//   b_angle: mean 8.42e-6 rad, largest seen 2.71e-5 rad at p0_x=1963 p0_y=-5912 p0_z=3005 p1_x=-2419 p1_y=-29264 p1_z=3178 p2_x=3140 p2_y=-14491 p2_z=-9385 uv0_u=-12799 uv0_v=-14422 uv1_u=-12907 uv1_v=-14588 uv2_u=-12803 uv2_v=-14411 view_x=19836 view_y=17280 view_z=-21533 light0_x=13751 light0_y=-21034 light0_z=22968
//   b_dot: mean 1.24e-5, largest seen 4.31e-5 at p0_x=-8559 p0_y=3166 p0_z=9556 p1_x=-8963 p1_y=3337 p1_z=9804 p2_x=-9467 p2_y=3695 p2_z=9468 uv0_u=-3765 uv0_v=1694 uv1_u=-398 uv1_v=210 uv2_u=-3397 uv2_v=239 view_x=-9751 view_y=7042 view_z=-6135 light0_x=-5164 light0_y=-18281 light0_z=2614
//   b_x: mean 6.23e-6, largest seen 3.58e-5 (2.3 ulp) at p0_x=-12491 p0_y=-10859 p0_z=770 p1_x=-12550 p1_y=-10848 p1_z=767 p2_x=-12546 p2_y=-10988 p2_z=739 uv0_u=4382 uv0_v=-5922 uv1_u=4734 uv1_v=-5405 uv2_u=4929 uv2_v=-5360 view_x=-2703 view_y=-1919 view_z=-3268 light0_x=-11057 light0_y=-18078 light0_z=5818
//   b_y: mean 6.24e-6, largest seen 3.57e-5 (2.3 ulp) at p0_x=-5519 p0_y=-6920 p0_z=-16251 p1_x=-6543 p1_y=-10156 p1_z=-12356 p2_x=-3878 p2_y=-9401 p2_z=-17652 uv0_u=16327 uv0_v=1287 uv1_u=16274 uv1_v=1188 uv2_u=16300 uv2_v=1216 view_x=-11982 view_y=-3585 view_z=8239 light0_x=14579 light0_y=-4365 light0_z=-1654
//   b_z: mean 6.22e-6, largest seen 3.80e-5 (2.5 ulp) at p0_x=-8559 p0_y=3166 p0_z=9556 p1_x=-8963 p1_y=3337 p1_z=9804 p2_x=-9467 p2_y=3695 p2_z=9468 uv0_u=-3765 uv0_v=1694 uv1_u=-398 uv1_v=210 uv2_u=-3397 uv2_v=239 view_x=-9751 view_y=7042 view_z=-6135 light0_x=-5164 light0_y=-18281 light0_z=2614
//   n_angle: mean 6.36e-6 rad, largest seen 2.03e-5 rad at p0_x=3522 p0_y=-9311 p0_z=-13297 p1_x=3357 p1_y=-9323 p1_z=-12966 p2_x=3631 p2_y=-9200 p2_z=-12705 uv0_u=14991 uv0_v=-10890 uv1_u=15093 uv1_v=-10788 uv2_u=14968 uv2_v=-10772 view_x=1356 view_y=2820 view_z=466 light0_x=-381 light0_y=-197 light0_z=-3135
//   n_dot: mean 8.51e-6, largest seen 2.45e-5 at p0_x=-12498 p0_y=-6604 p0_z=11609 p1_x=-12529 p1_y=-6828 p1_z=11660 p2_x=-12768 p2_y=-6749 p2_z=11792 uv0_u=-6142 uv0_v=-4000 uv1_u=-6192 uv1_v=-3960 uv2_u=-6137 uv2_v=-3885 view_x=-8383 view_y=-17561 view_z=-14050 light0_x=2468 light0_y=-3154 light0_z=2249
//   n_x: mean 4.34e-6, largest seen 1.92e-5 (1.3 ulp) at p0_x=10267 p0_y=-5838 p0_z=15884 p1_x=10309 p1_y=-6415 p1_z=16204 p2_x=10019 p2_y=-5989 p2_z=16833 uv0_u=11841 uv0_v=15625 uv1_u=11793 uv1_v=15714 uv2_u=11814 uv2_v=15848 view_x=-11567 view_y=-17040 view_z=20375 light0_x=4077 light0_y=-4110 light0_z=-2012
//   n_y: mean 4.34e-6, largest seen 2.01e-5 (1.3 ulp) at p0_x=-3279 p0_y=-11425 p0_z=-14595 p1_x=-1417 p1_y=-11167 p1_z=-13271 p2_x=-3268 p2_y=-11185 p2_z=-10092 uv0_u=-12491 uv0_v=-17511 uv1_u=-14563 uv1_v=-17231 uv2_u=-9992 uv2_v=-12759 view_x=2161 view_y=632 view_z=-3148 light0_x=-8712 light0_y=1511 light0_z=-18751
//   n_z: mean 4.35e-6, largest seen 1.94e-5 (1.3 ulp) at p0_x=-8946 p0_y=-7910 p0_z=13506 p1_x=-7691 p1_y=-6861 p1_z=12554 p2_x=-8776 p2_y=-8113 p2_z=13612 uv0_u=1238 uv0_v=11162 uv1_u=-24396 uv1_v=6826 uv2_u=1116 uv2_v=19470 view_x=-7019 view_y=18890 view_z=19636 light0_x=-3540 light0_y=2276 light0_z=864
//   ts_view_angle: mean 4.70e-5 rad, largest seen 1.93e-3 rad at p0_x=-15922 p0_y=-11294 p0_z=15571 p1_x=-16396 p1_y=-12074 p1_z=16206 p2_x=-16189 p2_y=-11575 p2_z=15362 uv0_u=-13956 uv0_v=11730 uv1_u=-14230 uv1_v=11819 uv2_u=-14204 uv2_v=11563 view_x=8 view_y=226 view_z=-193 light0_x=-3370 light0_y=4136 light0_z=-207
//   ts_view_dot: mean 3.07e-5, largest seen 9.87e-5 at p0_x=-12422 p0_y=-584 p0_z=17766 p1_x=-10564 p1_y=-1806 p1_z=15761 p2_x=-10865 p2_y=-707 p2_z=14787 uv0_u=-4921 uv0_v=-9044 uv1_u=-4950 uv1_v=-8878 uv2_u=-4919 uv2_v=-8658 view_x=-25528 view_y=29243 view_z=-23626 light0_x=16463 light0_y=-19456 light0_z=5126
//   ts_view_x: mean 1.57e-5, largest seen 6.94e-5 (1.1 ulp) at p0_x=-11634 p0_y=13444 p0_z=3163 p1_x=-11636 p1_y=13305 p1_z=3163 p2_x=-11498 p2_y=13032 p2_z=2986 uv0_u=-3984 uv0_v=4319 uv1_u=-1406 uv1_v=5555 uv2_u=-8008 uv2_v=4153 view_x=-29173 view_y=27295 view_z=-23629 light0_x=-5624 light0_y=-6697 light0_z=-22017
//   ts_view_y: mean 1.62e-5, largest seen 8.30e-5 (1.4 ulp) at p0_x=-12422 p0_y=-584 p0_z=17766 p1_x=-10564 p1_y=-1806 p1_z=15761 p2_x=-10865 p2_y=-707 p2_z=14787 uv0_u=-4921 uv0_v=-9044 uv1_u=-4950 uv1_v=-8878 uv2_u=-4919 uv2_v=-8658 view_x=-25528 view_y=29243 view_z=-23626 light0_x=16463 light0_y=-19456 light0_z=5126
//   ts_view_z: mean 1.57e-5, largest seen 6.55e-5 (1.1 ulp) at p0_x=-957 p0_y=-8937 p0_z=-7713 p1_x=-364 p1_y=-8872 p1_z=-7780 p2_x=-792 p2_y=-9101 p2_z=-7328 uv0_u=4922 uv0_v=8735 uv1_u=6366 uv1_v=9156 uv2_u=3517 uv2_v=8477 view_x=9889 view_y=-26230 view_z=30407 light0_x=1812 light0_y=9371 light0_z=-4170
//   ts_light0_angle: mean 4.70e-5 rad, largest seen 2.36e-3 rad at p0_x=1272 p0_y=-15486 p0_z=-8368 p1_x=1233 p1_y=-15508 p1_z=-8439 p2_x=1008 p2_y=-15725 p2_z=-7973 uv0_u=-15400 uv0_v=3547 uv1_u=-15342 uv1_v=3546 uv2_u=-15427 uv2_v=3464 view_x=12551 view_y=19257 view_z=19235 light0_x=171 light0_y=29 light0_z=72
//   ts_light0_dot: mean 3.07e-5, largest seen 9.98e-5 at p0_x=-11988 p0_y=-13056 p0_z=13072 p1_x=-11974 p1_y=-13110 p1_z=13097 p2_x=-12054 p2_y=-13094 p2_z=13191 uv0_u=-10382 uv0_v=-595 uv1_u=-9528 uv1_v=2995 uv2_u=-11248 uv2_v=-1849 view_x=6871 view_y=-6359 view_z=2657 light0_x=-23988 light0_y=21120 light0_z=-30573
//   ts_light0_x: mean 1.57e-5, largest seen 6.32e-5 (1.0 ulp) at p0_x=7888 p0_y=3589 p0_z=-13121 p1_x=7875 p1_y=3709 p1_z=-13121 p2_x=7918 p2_y=3694 p2_z=-13148 uv0_u=9779 uv0_v=1962 uv1_u=7432 uv1_v=3608 uv2_u=8427 uv2_v=2441 view_x=3142 view_y=4159 view_z=-5183 light0_x=-27369 light0_y=-16800 light0_z=21689
//   ts_light0_y: mean 1.62e-5, largest seen 8.70e-5 (1.4 ulp) at p0_x=-14343 p0_y=-11991 p0_z=-12374 p1_x=-14372 p1_y=-11824 p1_z=-12446 p2_x=-14291 p2_y=-11975 p2_z=-12373 uv0_u=-5769 uv0_v=1534 uv1_u=-5987 uv1_v=1672 uv2_u=-6200 uv2_v=1332 view_x=-6980 view_y=-3912 view_z=-6879 light0_x=-30401 light0_y=-28173 light0_z=-9748
//   ts_light0_z: mean 1.57e-5, largest seen 7.04e-5 (1.2 ulp) at p0_x=-5690 p0_y=415 p0_z=3882 p1_x=-5589 p1_y=304 p1_z=3842 p2_x=-5536 p2_y=796 p2_z=3703 uv0_u=3040 uv0_v=-7908 uv1_u=2474 uv1_v=-8467 uv2_u=2843 uv2_v=-8413 view_x=13849 view_y=10624 view_z=-14547 light0_x=-30873 light0_y=9385 light0_z=-31244
//   mirrored: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
//   degenerate: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
//   zero_uv: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
//   zero_area: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
// stated bound on each tangent: 5.74e-5
// stated bound on each binormal: 1.28e-4
// stated bound on each normal: 5.74e-5
// stated bound on each view: 5.78e-4
// stated bound on each light0: 5.78e-4
// stated bound on each flags: 0.00e0
//
// Verilator's harness of tangent_faceted: feeds vectors from a file, or from the standard input if
// there is none, with stalls and gaps now and then and a reset in mid-stream, and compares every
// bit of every output and the latency. The last line says PASS or FAIL; the status is 0 or 1.
#include "Vtangent_faceted.h"
#include "verilated.h"
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <vector>

static constexpr int kInputs = 21;
static constexpr int kOutputs = 19;
static constexpr int kFields = kInputs + kOutputs;
static constexpr int kLatency = 21;
static constexpr uint64_t kShown = 10;  // of the mismatches
static const char* const kNames[] = {"t_x", "t_y", "t_z", "b_x", "b_y", "b_z", "n_x", "n_y", "n_z", "ts_view_x", "ts_view_y", "ts_view_z", "ts_light0_x", "ts_light0_y", "ts_light0_z", "mirrored", "degenerate", "zero_uv", "zero_area"};

// Hexadecimal words, 40 a line.
class Vectors {
  public:
    explicit Vectors(FILE* file) : file_(file), buffer_(1 << 16) {}

    // False at the end; `cut` if it comes in the middle of a line.
    bool read(uint64_t* words, bool& cut) {
        for (int field = 0; field < kFields; ++field) {
            int c = next();
            while (c == ' ' || c == '\n' || c == '\r') c = next();
            if (c < 0) {
                cut = field > 0;
                return false;
            }
            uint64_t word = 0;
            for (; c > ' '; c = next()) {
                const int digit = c <= '9' ? c - '0' : (c | 32) - 'a' + 10;
                if (digit < 0 || digit > 15) {
                    cut = true;
                    return false;
                }
                word = word << 4 | static_cast<uint64_t>(digit);
            }
            words[field] = word;
        }
        return true;
    }

  private:
    int next() {
        if (at_ == end_) {
            at_ = 0;
            end_ = fread(buffer_.data(), 1, buffer_.size(), file_);
            if (end_ == 0) return -1;
        }
        return static_cast<unsigned char>(buffer_[at_++]);
    }

    FILE* file_;
    std::vector<char> buffer_;
    size_t at_ = 0;
    size_t end_ = 0;
};

struct Entry {
    bool valid = false;
    uint64_t number = 0;
    uint64_t words[kFields] = {};
};

template <typename Port>
static void put(Port& port, uint64_t word) {
    port = static_cast<Port>(word);
}

int main(int argc, char** argv) {
    FILE* const file = argc > 1 ? fopen(argv[1], "rb") : stdin;
    if (!file) {
        printf("FAIL: %s can't be read\n", argv[1]);
        return 1;
    }
    VerilatedContext context;
    Vtangent_faceted dut{&context};
    Vectors vectors(file);

    // What should come out, moving beside the pipeline; the newest at `head`.
    std::vector<Entry> pipe(kLatency + 1);
    int head = 0;
    // What a reset forgot goes in again.
    std::deque<Entry> again;
    uint64_t sent = 0, checked = 0, mismatches = 0;
    uint64_t random = 0x9e3779b97f4a7c15u;
    bool more = true, cut = false, reset_done = kLatency == 0;

    dut.rst = 1;
    dut.ce = 0;
    dut.valid_in = 0;
    dut.clk = 0;
    dut.eval();
    dut.clk = 1;
    dut.eval();
    dut.rst = 0;

    while (checked < sent || more) {
        random ^= random << 13;
        random ^= random >> 7;
        random ^= random << 17;
        // Which cycles stall and which are gaps is no function of the words.
        // A reset comes while the pipeline is full, during a stall, which doesn't hold it up.
        const bool reset = !reset_done && sent > kLatency;
        reset_done = reset_done || reset;
        const bool ce = kLatency == 0 || (!reset && (random & 15) != 0);
        const bool gap = (random >> 4 & 15) == 0;
        Entry& in = pipe[head];
        if (!in.valid && !gap && !again.empty()) {
            in = again.front();
            again.pop_front();
        } else if (!in.valid && !gap && more) {
            in.valid = more = vectors.read(in.words, cut);
            if (in.valid) in.number = sent++;
        }
        dut.valid_in = in.valid;
        put(dut.p0_x, (in.valid ? in.words[0] : ~in.words[0]) & UINT64_C(0xffff));
        put(dut.p0_y, (in.valid ? in.words[1] : ~in.words[1]) & UINT64_C(0xffff));
        put(dut.p0_z, (in.valid ? in.words[2] : ~in.words[2]) & UINT64_C(0xffff));
        put(dut.p1_x, (in.valid ? in.words[3] : ~in.words[3]) & UINT64_C(0xffff));
        put(dut.p1_y, (in.valid ? in.words[4] : ~in.words[4]) & UINT64_C(0xffff));
        put(dut.p1_z, (in.valid ? in.words[5] : ~in.words[5]) & UINT64_C(0xffff));
        put(dut.p2_x, (in.valid ? in.words[6] : ~in.words[6]) & UINT64_C(0xffff));
        put(dut.p2_y, (in.valid ? in.words[7] : ~in.words[7]) & UINT64_C(0xffff));
        put(dut.p2_z, (in.valid ? in.words[8] : ~in.words[8]) & UINT64_C(0xffff));
        put(dut.uv0_u, (in.valid ? in.words[9] : ~in.words[9]) & UINT64_C(0xffff));
        put(dut.uv0_v, (in.valid ? in.words[10] : ~in.words[10]) & UINT64_C(0xffff));
        put(dut.uv1_u, (in.valid ? in.words[11] : ~in.words[11]) & UINT64_C(0xffff));
        put(dut.uv1_v, (in.valid ? in.words[12] : ~in.words[12]) & UINT64_C(0xffff));
        put(dut.uv2_u, (in.valid ? in.words[13] : ~in.words[13]) & UINT64_C(0xffff));
        put(dut.uv2_v, (in.valid ? in.words[14] : ~in.words[14]) & UINT64_C(0xffff));
        put(dut.view_x, (in.valid ? in.words[15] : ~in.words[15]) & UINT64_C(0xffff));
        put(dut.view_y, (in.valid ? in.words[16] : ~in.words[16]) & UINT64_C(0xffff));
        put(dut.view_z, (in.valid ? in.words[17] : ~in.words[17]) & UINT64_C(0xffff));
        put(dut.light0_x, (in.valid ? in.words[18] : ~in.words[18]) & UINT64_C(0xffff));
        put(dut.light0_y, (in.valid ? in.words[19] : ~in.words[19]) & UINT64_C(0xffff));
        put(dut.light0_z, (in.valid ? in.words[20] : ~in.words[20]) & UINT64_C(0xffff));
        dut.ce = ce;
        dut.rst = reset;
        dut.clk = 0;
        dut.eval();

        const Entry& out = pipe[(head + kLatency) % (kLatency + 1)];
        if (dut.valid_out != out.valid && ++mismatches <= kShown) {
            printf("mismatch: vector %" PRIu64 " valid_out expected %d got %d\n", out.valid ? out.number : sent,
                   out.valid, dut.valid_out);
        }
        if (ce && out.valid) {
            const uint64_t got[] = {static_cast<uint64_t>(dut.t_x), static_cast<uint64_t>(dut.t_y), static_cast<uint64_t>(dut.t_z), static_cast<uint64_t>(dut.b_x), static_cast<uint64_t>(dut.b_y), static_cast<uint64_t>(dut.b_z), static_cast<uint64_t>(dut.n_x), static_cast<uint64_t>(dut.n_y), static_cast<uint64_t>(dut.n_z), static_cast<uint64_t>(dut.ts_view_x), static_cast<uint64_t>(dut.ts_view_y), static_cast<uint64_t>(dut.ts_view_z), static_cast<uint64_t>(dut.ts_light0_x), static_cast<uint64_t>(dut.ts_light0_y), static_cast<uint64_t>(dut.ts_light0_z), static_cast<uint64_t>(dut.mirrored), static_cast<uint64_t>(dut.degenerate), static_cast<uint64_t>(dut.zero_uv), static_cast<uint64_t>(dut.zero_area)};
            for (int i = 0; i < kOutputs; ++i) {
                const uint64_t expected = out.words[kInputs + i];
                if (got[i] != expected && ++mismatches <= kShown) {
                    printf("mismatch: vector %" PRIu64 " %s expected %" PRIx64 " got %" PRIx64 "\n", out.number,
                           kNames[i], expected, got[i]);
                }
            }
            ++checked;
        }
        if (ce) {
            // The oldest entry becomes the newest.
            head = (head + kLatency) % (kLatency + 1);
            pipe[head].valid = false;
        }
        for (int stage = kLatency; reset && stage > 0; --stage) {
            Entry& forgotten = pipe[(head + stage) % (kLatency + 1)];
            if (forgotten.valid) again.push_back(forgotten);
            forgotten.valid = false;
        }
        dut.clk = 1;
        dut.eval();
    }
    dut.final();
    if (cut) printf("mismatch: the vectors are cut short after vector %" PRIu64 "\n", sent);
    if (sent == 0) printf("mismatch: there is no vector\n");
    if (cut || sent == 0 || mismatches > 0) {
        printf("FAIL %" PRIu64 " mismatches in %" PRIu64 " vectors\n", mismatches, checked);
        return 1;
    }
    printf("PASS %" PRIu64 " vectors\n", checked);
    return 0;
}
