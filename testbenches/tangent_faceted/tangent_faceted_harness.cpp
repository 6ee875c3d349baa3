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
//   t_angle: mean 6.48e-6 rad, at most 1.96e-5 rad at p0_x=17354 p0_y=8360 p0_z=19876 p1_x=12416 p1_y=2144 p1_z=6776 p2_x=6288 p2_y=7448 p2_z=26840 uv0_u=-11814 uv0_v=-11791 uv1_u=-11843 uv1_v=-11706 uv2_u=-11757 uv2_v=-11667 view_x=-578 view_y=-3659 view_z=1930 light0_x=3235 light0_y=7280 light0_z=8272
//   t_dot: mean 8.62e-6, at most 2.31e-5 at p0_x=-3977 p0_y=-2247 p0_z=12757 p1_x=-7571 p1_y=-7658 p1_z=12820 p2_x=156 p2_y=-4587 p2_z=10504 uv0_u=9002 uv0_v=13737 uv1_u=9046 uv1_v=13793 uv2_u=9051 uv2_v=13663 view_x=-1267 view_y=4021 view_z=-333 light0_x=389 light0_y=-3071 light0_z=2715
//   t_x: mean 4.40e-6, at most 1.97e-5 (1.3 ulp) at p0_x=9284 p0_y=-3493 p0_z=-3736 p1_x=9160 p1_y=-3452 p1_z=-3609 p2_x=9019 p2_y=-3386 p2_z=-3771 uv0_u=-16367 uv0_v=-7717 uv1_u=-13327 uv1_v=-5585 uv2_u=-18661 uv2_v=-10805 view_x=-5671 view_y=-8782 view_z=-1494 light0_x=-3709 light0_y=-8505 light0_z=6138
//   t_y: mean 4.40e-6, at most 1.96e-5 (1.3 ulp) at p0_x=3279 p0_y=8679 p0_z=-15980 p1_x=2427 p1_y=8671 p1_z=-15309 p2_x=2885 p2_y=8087 p2_z=-15477 uv0_u=-13104 uv0_v=-4401 uv1_u=-14609 uv1_v=-7850 uv2_u=-15592 uv2_v=-6185 view_x=3937 view_y=-16021 view_z=6330 light0_x=297 light0_y=9264 light0_z=-17765
//   t_z: mean 4.38e-6, at most 2.01e-5 (1.3 ulp) at p0_x=-8725 p0_y=14727 p0_z=13006 p1_x=-8699 p1_y=14847 p1_z=12986 p2_x=-8743 p2_y=14816 p2_z=13059 uv0_u=939 uv0_v=-2961 uv1_u=-1521 uv1_v=-6402 uv2_u=1418 uv2_v=-5400 view_x=-1506 view_y=3177 view_z=3849 light0_x=14610 light0_y=-7690 light0_z=-621
//   b_angle: mean 8.45e-6 rad, at most 2.69e-5 rad at p0_x=4185 p0_y=7298 p0_z=5131 p1_x=5334 p1_y=10722 p1_z=2325 p2_x=9456 p2_y=8256 p2_z=4578 uv0_u=-6024 uv0_v=-2922 uv1_u=-5129 uv1_v=-3864 uv2_u=-4903 uv2_v=-2852 view_x=-31824 view_y=3119 view_z=-5355 light0_x=16649 light0_y=-8093 light0_z=7604
//   b_dot: mean 1.24e-5, at most 4.13e-5 at p0_x=2727 p0_y=-15657 p0_z=-1825 p1_x=2139 p1_y=-13562 p1_z=-2014 p2_x=1581 p2_y=-15644 p2_z=-3682 uv0_u=-14348 uv0_v=-2260 uv1_u=-14803 uv1_v=-1795 uv2_u=-13838 uv2_v=-1973 view_x=4453 view_y=1001 view_z=-845 light0_x=-1055 light0_y=3371 light0_z=8300
//   b_x: mean 6.24e-6, at most 3.38e-5 (2.2 ulp) at p0_x=-9895 p0_y=1127 p0_z=8564 p1_x=-5361 p1_y=-5195 p1_z=-2305 p2_x=-4941 p2_y=2729 p2_z=9830 uv0_u=4016 uv0_v=-13259 uv1_u=4394 uv1_v=-13444 uv2_u=4313 uv2_v=-13581 view_x=-1478 view_y=8678 view_z=540 light0_x=-4528 light0_y=-5963 light0_z=19418
//   b_y: mean 6.23e-6, at most 3.39e-5 (2.2 ulp) at p0_x=-15019 p0_y=9014 p0_z=-13295 p1_x=-14507 p1_y=8933 p1_z=-12869 p2_x=-14987 p2_y=8562 p2_z=-13317 uv0_u=-14881 uv0_v=15595 uv1_u=-14823 uv1_v=15588 uv2_u=-14894 uv2_v=15693 view_x=2866 view_y=-4790 view_z=4016 light0_x=9546 light0_y=-921 light0_z=-8693
//   b_z: mean 6.24e-6, at most 3.48e-5 (2.3 ulp) at p0_x=-3692 p0_y=8154 p0_z=-10601 p1_x=-3711 p1_y=7749 p1_z=-10993 p2_x=-3945 p2_y=8012 p2_z=-10163 uv0_u=1555 uv0_v=-2538 uv1_u=1241 uv1_v=-2775 uv2_u=1226 uv2_v=-2342 view_x=6019 view_y=4765 view_z=1213 light0_x=-15436 light0_y=-2902 light0_z=13127
//   n_angle: mean 6.35e-6 rad, at most 2.11e-5 rad at p0_x=-8525 p0_y=5610 p0_z=14302 p1_x=-7985 p1_y=5335 p1_z=14453 p2_x=-8307 p2_y=6017 p2_z=14413 uv0_u=-14033 uv0_v=10384 uv1_u=-14566 uv1_v=9742 uv2_u=-15380 uv2_v=9625 view_x=-4112 view_y=4 view_z=465 light0_x=-4351 light0_y=-1403 light0_z=6776
//   n_dot: mean 8.50e-6, at most 2.54e-5 at p0_x=5670 p0_y=-1432 p0_z=-9760 p1_x=6211 p1_y=-2614 p1_z=-10342 p2_x=5615 p2_y=-1477 p2_z=-10166 uv0_u=6046 uv0_v=-13851 uv1_u=6205 uv1_v=-13667 uv2_u=6116 uv2_v=-13752 view_x=-5628 view_y=-10551 view_z=1846 light0_x=-2820 light0_y=3776 light0_z=-729
//   n_x: mean 4.32e-6, at most 1.97e-5 (1.3 ulp) at p0_x=-5587 p0_y=-9777 p0_z=-4927 p1_x=-5685 p1_y=-10675 p1_z=-13686 p2_x=-7131 p2_y=-14045 p2_z=-11875 uv0_u=18660 uv0_v=5079 uv1_u=18028 uv1_v=6508 uv2_u=15304 uv2_v=3518 view_x=10808 view_y=13351 view_z=-12460 light0_x=-2302 light0_y=585 light0_z=5071
//   n_y: mean 4.33e-6, at most 1.99e-5 (1.3 ulp) at p0_x=-10042 p0_y=-1339 p0_z=-3039 p1_x=-9952 p1_y=-1055 p1_z=-3726 p2_x=-10343 p2_y=-1458 p2_z=-3187 uv0_u=-7735 uv0_v=3129 uv1_u=-9856 uv1_v=147 uv2_u=-5085 uv2_v=6386 view_x=4704 view_y=-870 view_z=-148 light0_x=-1652 light0_y=8593 light0_z=26892
//   n_z: mean 4.35e-6, at most 1.97e-5 (1.3 ulp) at p0_x=14877 p0_y=-20515 p0_z=-17729 p1_x=14758 p1_y=543 p1_z=-10852 p2_x=2720 p2_y=3217 p2_z=-6578 uv0_u=-16018 uv0_v=-4401 uv1_u=-8707 uv1_v=3321 uv2_u=-11736 uv2_v=2209 view_x=8990 view_y=-905 view_z=2405 light0_x=1272 light0_y=-3105 light0_z=3092
//   ts_view_angle: mean 3.95e-5 rad, at most 2.00e-4 rad at p0_x=-15816 p0_y=1594 p0_z=-5449 p1_x=-9136 p1_y=-967 p1_z=-9324 p2_x=-8817 p2_y=7877 p2_z=-10436 uv0_u=-3252 uv0_v=-1882 uv1_u=-3334 uv1_v=-2003 uv2_u=-3218 uv2_v=-1654 view_x=489 view_y=3026 view_z=-2754 light0_x=4389 light0_y=-1970 light0_z=-4583
//   ts_view_dot: mean 3.07e-5, at most 8.46e-5 at p0_x=14650 p0_y=5324 p0_z=-11359 p1_x=14934 p1_y=5318 p1_z=-11666 p2_x=14912 p2_y=5480 p2_z=-11532 uv0_u=-16511 uv0_v=1868 uv1_u=-12104 uv1_v=-4 uv2_u=-13683 uv2_v=-1262 view_x=-5426 view_y=-31528 view_z=-4848 light0_x=-6143 light0_y=-4864 light0_z=-5443
//   ts_view_x: mean 1.57e-5, at most 5.88e-5 (1.0 ulp) at p0_x=5878 p0_y=7518 p0_z=16795 p1_x=5739 p1_y=12805 p1_z=18195 p2_x=5657 p2_y=7023 p2_z=13923 uv0_u=4015 uv0_v=-9102 uv1_u=3078 uv1_v=-9754 uv2_u=453 uv2_v=-9180 view_x=7735 view_y=-14355 view_z=-23535 light0_x=-2007 light0_y=-4241 light0_z=4390
//   ts_view_y: mean 1.62e-5, at most 7.65e-5 (1.3 ulp) at p0_x=-15315 p0_y=-5364 p0_z=-7467 p1_x=-15280 p1_y=-5299 p1_z=-7428 p2_x=-15302 p2_y=-5390 p2_z=-7483 uv0_u=-14473 uv0_v=4154 uv1_u=-16381 uv1_v=3415 uv2_u=-14957 uv2_v=4258 view_x=15606 view_y=25390 view_z=8391 light0_x=-4073 light0_y=1815 light0_z=2848
//   ts_view_z: mean 1.57e-5, at most 6.11e-5 (1.0 ulp) at p0_x=2993 p0_y=-1901 p0_z=-15333 p1_x=2596 p1_y=-1843 p1_z=-15320 p2_x=2677 p2_y=-1826 p2_z=-15494 uv0_u=-12722 uv0_v=8038 uv1_u=-12488 uv1_v=6556 uv2_u=-11750 uv2_v=6793 view_x=-14610 view_y=27993 view_z=7804 light0_x=2639 light0_y=7019 light0_z=-6813
//   ts_light0_angle: mean 3.95e-5 rad, at most 2.02e-4 rad at p0_x=-14877 p0_y=-12093 p0_z=10707 p1_x=-14855 p1_y=-13082 p1_z=11444 p2_x=-15811 p2_y=-13450 p2_z=12922 uv0_u=-6384 uv0_v=11918 uv1_u=-7618 uv1_v=14629 uv2_u=-6954 uv2_v=12881 view_x=-4883 view_y=3104 view_z=4535 light0_x=3630 light0_y=-372 light0_z=1907
//   ts_light0_dot: mean 3.07e-5, at most 7.62e-5 at p0_x=-5249 p0_y=1656 p0_z=-8042 p1_x=-5147 p1_y=1461 p1_z=-7922 p2_x=-4034 p2_y=2058 p2_z=-8565 uv0_u=-16871 uv0_v=7696 uv1_u=-16727 uv1_v=8704 uv2_u=-17083 uv2_v=7924 view_x=13448 view_y=7249 view_z=23744 light0_x=24517 light0_y=13885 light0_z=-4514
//   ts_light0_x: mean 1.57e-5, at most 6.33e-5 (1.0 ulp) at p0_x=-5836 p0_y=3280 p0_z=3011 p1_x=-5771 p1_y=6594 p1_z=6951 p2_x=-7742 p2_y=6237 p2_z=2998 uv0_u=-5577 uv0_v=-8593 uv1_u=-5536 uv1_v=-8633 uv2_u=-5220 uv2_v=-8711 view_x=-4235 view_y=8857 view_z=16296 light0_x=685 light0_y=12183 light0_z=27317
//   ts_light0_y: mean 1.62e-5, at most 7.48e-5 (1.2 ulp) at p0_x=11802 p0_y=-7858 p0_z=4797 p1_x=12464 p1_y=-8360 p1_z=2055 p2_x=14542 p2_y=-8593 p2_z=6048 uv0_u=6880 uv0_v=-5961 uv1_u=6256 uv1_v=-5671 uv2_u=7430 uv2_v=-3745 view_x=3647 view_y=2488 view_z=-1186 light0_x=-29774 light0_y=7315 light0_z=1107
//   ts_light0_z: mean 1.57e-5, at most 6.10e-5 (1.0 ulp) at p0_x=4679 p0_y=2416 p0_z=-2219 p1_x=4733 p1_y=2362 p1_z=-2206 p2_x=4771 p2_y=2354 p2_z=-2255 uv0_u=-12814 uv0_v=-14947 uv1_u=-12760 uv1_v=-15047 uv2_u=-12793 uv2_v=-15042 view_x=-9785 view_y=8500 view_z=-2064 light0_x=17552 light0_y=27551 light0_z=234
//   mirrored: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-2251 p0_y=-12103 p0_z=-4471 p1_x=-2315 p1_y=-12265 p1_z=-4389 p2_x=-2396 p2_y=-12196 p2_z=-4368 uv0_u=-15135 uv0_v=-8131 uv1_u=-7065 uv1_v=-24240 uv2_u=-5879 uv2_v=-14467 view_x=-498 view_y=-7436 view_z=1651 light0_x=-5316 light0_y=3367 light0_z=5947
//   degenerate: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-2251 p0_y=-12103 p0_z=-4471 p1_x=-2315 p1_y=-12265 p1_z=-4389 p2_x=-2396 p2_y=-12196 p2_z=-4368 uv0_u=-15135 uv0_v=-8131 uv1_u=-7065 uv1_v=-24240 uv2_u=-5879 uv2_v=-14467 view_x=-498 view_y=-7436 view_z=1651 light0_x=-5316 light0_y=3367 light0_z=5947
//   zero_uv: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-2251 p0_y=-12103 p0_z=-4471 p1_x=-2315 p1_y=-12265 p1_z=-4389 p2_x=-2396 p2_y=-12196 p2_z=-4368 uv0_u=-15135 uv0_v=-8131 uv1_u=-7065 uv1_v=-24240 uv2_u=-5879 uv2_v=-14467 view_x=-498 view_y=-7436 view_z=1651 light0_x=-5316 light0_y=3367 light0_z=5947
//   zero_area: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-2251 p0_y=-12103 p0_z=-4471 p1_x=-2315 p1_y=-12265 p1_z=-4389 p2_x=-2396 p2_y=-12196 p2_z=-4368 uv0_u=-15135 uv0_v=-8131 uv1_u=-7065 uv1_v=-24240 uv2_u=-5879 uv2_v=-14467 view_x=-498 view_y=-7436 view_z=1651 light0_x=-5316 light0_y=3367 light0_z=5947
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
