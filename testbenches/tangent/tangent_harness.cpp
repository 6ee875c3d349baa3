// tangent: tangent-space set-up of a triangle's vertex: map, view vector and lights in texture space
// made by fixpath 0.1.0; seed 004 (US 7,843,463), with its mirroring rule and facets as printed and mended
//   frame=smooth mirror=handed basis=orthonormal lights=1 position_int_bits=4
//   position_frac_bits=11 uv_int_bits=2 uv_frac_bits=13 component_bits=16 guard_bits=2
//   vector_int_bits=1 vector_bits=16 out_frac_bits=14 norm_bits=18 dot_frac_bits=20
//   root_scheme=linear root_addr_bits=8 root_frac_bits=18 rounding=half-up period_ps=5000
//   stages=auto rom=block
// latency 23 cycles, interval 1 cycle; tables read on the clock
// absolute errors against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   t_angle: mean 7.21e-6 rad, largest seen 2.54e-5 rad at p0_x=4623 p0_y=93 p0_z=-11681 p1_x=1115 p1_y=2879 p1_z=-11038 p2_x=-2614 p2_y=-2532 p2_z=-6132 uv0_u=4801 uv0_v=7643 uv1_u=4785 uv1_v=7656 uv2_u=4827 uv2_v=7658 normal_x=-9446 normal_y=5706 normal_z=-12110 view_x=6001 view_y=15627 view_z=-16959 light0_x=25729 light0_y=-15361 light0_z=-23275
//   t_dot: mean 1.01e-5, largest seen 3.06e-5 at p0_x=6054 p0_y=-8713 p0_z=-8201 p1_x=6085 p1_y=-8615 p1_z=-7909 p2_x=5792 p2_y=-8522 p2_z=-8101 uv0_u=4564 uv0_v=5160 uv1_u=2779 uv1_v=4462 uv2_u=3578 uv2_v=3905 normal_x=12043 normal_y=-10167 normal_z=4476 view_x=2660 view_y=-1823 view_z=-11081 light0_x=8046 light0_y=-6155 light0_z=-4370
//   t_x: mean 5.06e-6, largest seen 2.58e-5 (1.7 ulp) at p0_x=-2944 p0_y=-2889 p0_z=-15380 p1_x=-1989 p1_y=-3042 p1_z=-15024 p2_x=35 p2_y=-907 p2_z=-15910 uv0_u=7874 uv0_v=-4729 uv1_u=7659 uv1_v=-5304 uv2_u=7814 uv2_v=-4572 normal_x=-5414 normal_y=14396 normal_z=-5646 view_x=-6397 view_y=-7256 view_z=184 light0_x=9737 light0_y=-6526 light0_z=-23310
//   t_y: mean 5.08e-6, largest seen 2.63e-5 (1.7 ulp) at p0_x=-5717 p0_y=-7520 p0_z=6199 p1_x=-6348 p1_y=-7947 p1_z=6354 p2_x=-5905 p2_y=-7260 p2_z=6487 uv0_u=-5576 uv0_v=-14859 uv1_u=-5475 uv1_v=-15100 uv2_u=-5440 uv2_v=-15020 normal_x=10034 normal_y=-493 normal_z=12942 view_x=13000 view_y=-2147 view_z=4664 light0_x=2385 light0_y=2146 light0_z=-3481
//   t_z: mean 5.08e-6, largest seen 2.65e-5 (1.7 ulp) at p0_x=11563 p0_y=11423 p0_z=-13723 p1_x=11421 p1_y=11299 p1_z=-13637 p2_x=11555 p2_y=11375 p2_z=-13787 uv0_u=-8499 uv0_v=13103 uv1_u=-7478 uv1_v=7491 uv2_u=-5140 uv2_v=11461 normal_x=-15164 normal_y=-4331 normal_z=-4443 view_x=-8107 view_y=1299 view_z=-3290 light0_x=-3604 light0_y=-1965 light0_z=440
//   b_angle: mean 6.61e-6 rad, largest seen 2.02e-5 rad at p0_x=21760 p0_y=-8046 p0_z=-19764 p1_x=14314 p1_y=-6846 p1_z=-24032 p2_x=12189 p2_y=-1901 p2_z=-15526 uv0_u=-22738 uv0_v=-3849 uv1_u=-23752 uv1_v=1069 uv2_u=-9213 uv2_v=2636 normal_x=-12722 normal_y=-9837 normal_z=-3133 view_x=9645 view_y=-6931 view_z=4827 light0_x=9603 light0_y=-8865 light0_z=-8833
//   b_dot: mean 8.71e-6, largest seen 2.37e-5 at p0_x=5680 p0_y=11679 p0_z=-9279 p1_x=5746 p1_y=11714 p1_z=-9304 p2_x=5771 p2_y=11695 p2_z=-9339 uv0_u=10373 uv0_v=-9936 uv1_u=10462 uv1_v=-9889 uv2_u=10455 uv2_v=-9822 normal_x=-13791 normal_y=8267 normal_z=-3145 view_x=4674 view_y=15361 view_z=-4755 light0_x=19009 light0_y=22102 light0_z=-24134
//   b_x: mean 4.44e-6, largest seen 1.88e-5 (1.2 ulp) at p0_x=-1736 p0_y=11116 p0_z=-16007 p1_x=-158 p1_y=11485 p1_z=-16948 p2_x=-1615 p2_y=13286 p2_z=-16701 uv0_u=1006 uv0_v=13794 uv1_u=1018 uv1_v=13841 uv2_u=1173 uv2_v=13774 normal_x=2071 normal_y=16139 normal_z=1917 view_x=1686 view_y=4755 view_z=-5926 light0_x=-2682 light0_y=5065 light0_z=3979
//   b_y: mean 4.43e-6, largest seen 2.10e-5 (1.4 ulp) at p0_x=16361 p0_y=11747 p0_z=-5803 p1_x=17315 p1_y=13651 p1_z=-4641 p2_x=13325 p2_y=13955 p2_z=-4680 uv0_u=-5823 uv0_v=-9319 uv1_u=-5674 uv1_v=-9605 uv2_u=-5470 uv2_v=-9514 normal_x=-222 normal_y=-9338 normal_z=-13460 view_x=16239 view_y=-23962 view_z=-7113 light0_x=-1942 light0_y=2415 light0_z=-9419
//   b_z: mean 4.44e-6, largest seen 1.95e-5 (1.3 ulp) at p0_x=-11834 p0_y=478 p0_z=2468 p1_x=-12147 p1_y=607 p1_z=2446 p2_x=-11996 p2_y=633 p2_z=2585 uv0_u=14968 uv0_v=4654 uv1_u=15202 uv1_v=4821 uv2_u=14888 uv2_v=4438 normal_x=6949 normal_y=-14815 normal_z=819 view_x=1968 view_y=-7156 view_z=-750 light0_x=-14564 light0_y=-2007 light0_z=1544
//   n_angle: mean 0.00e0 rad, largest seen 0.00e0 rad at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
//   n_dot: mean 0.00e0, largest seen 0.00e0 at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
//   n_x: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
//   n_y: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
//   n_z: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
//   ts_view_angle: mean 4.65e-5 rad, largest seen 1.84e-3 rad at p0_x=-9855 p0_y=-11563 p0_z=4028 p1_x=-14143 p1_y=-4409 p1_z=482 p2_x=-8004 p2_y=7008 p2_z=-4249 uv0_u=-4218 uv0_v=9266 uv1_u=-4223 uv1_v=9363 uv2_u=-4208 uv2_v=9267 normal_x=-15042 normal_y=-4819 normal_z=-4353 view_x=72 view_y=-168 view_z=98 light0_x=2154 light0_y=-1130 light0_z=-105
//   ts_view_dot: mean 3.01e-5, largest seen 9.03e-5 at p0_x=6141 p0_y=-13767 p0_z=-7992 p1_x=6118 p1_y=-13719 p1_z=-7838 p2_x=6123 p2_y=-13790 p2_z=-7826 uv0_u=7545 uv0_v=-11434 uv1_u=7546 uv1_v=-10295 uv2_u=6797 uv2_v=-11328 normal_x=-403 normal_y=-14238 normal_z=8096 view_x=16190 view_y=26021 view_z=27329 light0_x=-4445 light0_y=5173 light0_z=5980
//   ts_view_x: mean 1.58e-5, largest seen 7.72e-5 (1.3 ulp) at p0_x=-9548 p0_y=7900 p0_z=-11270 p1_x=-9660 p1_y=7935 p1_z=-11194 p2_x=-9357 p2_y=7961 p2_z=-11076 uv0_u=-11107 uv0_v=12419 uv1_u=-11523 uv1_v=11905 uv2_u=-10978 uv2_v=12656 normal_x=-5642 normal_y=12921 normal_z=-8346 view_x=23883 view_y=22119 view_z=16603 light0_x=6062 light0_y=11713 light0_z=2836
//   ts_view_y: mean 1.57e-5, largest seen 6.24e-5 (1.0 ulp) at p0_x=15652 p0_y=10540 p0_z=7166 p1_x=15633 p1_y=10607 p1_z=7228 p2_x=15553 p2_y=10667 p2_z=7290 uv0_u=-1788 uv0_v=-6270 uv1_u=-322 uv1_v=-6844 uv2_u=-1575 uv2_v=-7200 normal_x=-1833 normal_y=16240 normal_z=1159 view_x=-29460 view_y=31001 view_z=3770 light0_x=6127 light0_y=-7450 light0_z=7013
//   ts_view_z: mean 1.52e-5, largest seen 3.05e-5 (0.5 ulp) at p0_x=-302 p0_y=1691 p0_z=-6673 p1_x=-221 p1_y=1773 p1_z=-6705 p2_x=-254 p2_y=1753 p2_z=-6603 uv0_u=7868 uv0_v=821 uv1_u=8711 uv1_v=2841 uv2_u=6860 uv2_v=2720 normal_x=-10163 normal_y=-7193 normal_z=10649 view_x=4532 view_y=-9269 view_z=10375 light0_x=-2930 light0_y=-241 light0_z=2769
//   ts_light0_angle: mean 4.66e-5 rad, largest seen 2.30e-3 rad at p0_x=1272 p0_y=-15486 p0_z=-8368 p1_x=1233 p1_y=-15508 p1_z=-8439 p2_x=1008 p2_y=-15725 p2_z=-7973 uv0_u=-15400 uv0_v=3547 uv1_u=-15342 uv1_v=3546 uv2_u=-15427 uv2_v=3464 normal_x=-13112 normal_y=6323 normal_z=-7519 view_x=12551 view_y=19257 view_z=19235 light0_x=171 light0_y=29 light0_z=72
//   ts_light0_dot: mean 3.01e-5, largest seen 8.52e-5 at p0_x=4623 p0_y=93 p0_z=-11681 p1_x=1115 p1_y=2879 p1_z=-11038 p2_x=-2614 p2_y=-2532 p2_z=-6132 uv0_u=4801 uv0_v=7643 uv1_u=4785 uv1_v=7656 uv2_u=4827 uv2_v=7658 normal_x=-9446 normal_y=5706 normal_z=-12110 view_x=6001 view_y=15627 view_z=-16959 light0_x=25729 light0_y=-15361 light0_z=-23275
//   ts_light0_x: mean 1.58e-5, largest seen 7.53e-5 (1.2 ulp) at p0_x=4623 p0_y=93 p0_z=-11681 p1_x=1115 p1_y=2879 p1_z=-11038 p2_x=-2614 p2_y=-2532 p2_z=-6132 uv0_u=4801 uv0_v=7643 uv1_u=4785 uv1_v=7656 uv2_u=4827 uv2_v=7658 normal_x=-9446 normal_y=5706 normal_z=-12110 view_x=6001 view_y=15627 view_z=-16959 light0_x=25729 light0_y=-15361 light0_z=-23275
//   ts_light0_y: mean 1.57e-5, largest seen 6.57e-5 (1.1 ulp) at p0_x=15543 p0_y=13758 p0_z=-4075 p1_x=14753 p1_y=14130 p1_z=-3927 p2_x=15086 p2_y=13483 p2_z=-3280 uv0_u=-1025 uv0_v=12037 uv1_u=1063 uv1_v=12449 uv2_u=-1376 uv2_v=6924 normal_x=-3845 normal_y=-15786 normal_z=2110 view_x=-2307 view_y=-1803 view_z=2775 light0_x=-13005 light0_y=25943 light0_z=-29219
//   ts_light0_z: mean 1.52e-5, largest seen 3.05e-5 (0.5 ulp) at p0_x=12149 p0_y=11346 p0_z=-31 p1_x=12282 p1_y=11313 p1_z=-4 p2_x=12253 p2_y=11302 p2_z=-166 uv0_u=-16266 uv0_v=8823 uv1_u=-11398 uv1_v=9264 uv2_u=-14519 uv2_v=5465 normal_x=-2913 normal_y=-16026 normal_z=1769 view_x=-3200 view_y=-5150 view_z=-2933 light0_x=3519 light0_y=12209 light0_z=-5007
//   mirrored: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
//   degenerate: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
//   zero_uv: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
//   zero_area: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
//   parallel: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
// stated bound on each tangent: 2.12e-4
// stated bound on each binormal: 5.74e-5
// stated bound on each normal: 0.00e0
// stated bound on each view: 8.14e-4
// stated bound on each light0: 8.14e-4
// stated bound on each flags: 0.00e0
//
// Verilator's harness of tangent: feeds vectors from a file, or from the standard input if
// there is none, with stalls and gaps now and then and a reset in mid-stream, and compares every
// bit of every output and the latency. The last line says PASS or FAIL; the status is 0 or 1.
#include "Vtangent.h"
#include "verilated.h"
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <vector>

static constexpr int kInputs = 24;
static constexpr int kOutputs = 20;
static constexpr int kFields = kInputs + kOutputs;
static constexpr int kLatency = 23;
static constexpr uint64_t kShown = 10;  // of the mismatches
static const char* const kNames[] = {"t_x", "t_y", "t_z", "b_x", "b_y", "b_z", "n_x", "n_y", "n_z", "ts_view_x", "ts_view_y", "ts_view_z", "ts_light0_x", "ts_light0_y", "ts_light0_z", "mirrored", "degenerate", "zero_uv", "zero_area", "parallel"};

// Hexadecimal words, 44 a line.
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
    Vtangent dut{&context};
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
        put(dut.normal_x, (in.valid ? in.words[15] : ~in.words[15]) & UINT64_C(0xffff));
        put(dut.normal_y, (in.valid ? in.words[16] : ~in.words[16]) & UINT64_C(0xffff));
        put(dut.normal_z, (in.valid ? in.words[17] : ~in.words[17]) & UINT64_C(0xffff));
        put(dut.view_x, (in.valid ? in.words[18] : ~in.words[18]) & UINT64_C(0xffff));
        put(dut.view_y, (in.valid ? in.words[19] : ~in.words[19]) & UINT64_C(0xffff));
        put(dut.view_z, (in.valid ? in.words[20] : ~in.words[20]) & UINT64_C(0xffff));
        put(dut.light0_x, (in.valid ? in.words[21] : ~in.words[21]) & UINT64_C(0xffff));
        put(dut.light0_y, (in.valid ? in.words[22] : ~in.words[22]) & UINT64_C(0xffff));
        put(dut.light0_z, (in.valid ? in.words[23] : ~in.words[23]) & UINT64_C(0xffff));
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
            const uint64_t got[] = {static_cast<uint64_t>(dut.t_x), static_cast<uint64_t>(dut.t_y), static_cast<uint64_t>(dut.t_z), static_cast<uint64_t>(dut.b_x), static_cast<uint64_t>(dut.b_y), static_cast<uint64_t>(dut.b_z), static_cast<uint64_t>(dut.n_x), static_cast<uint64_t>(dut.n_y), static_cast<uint64_t>(dut.n_z), static_cast<uint64_t>(dut.ts_view_x), static_cast<uint64_t>(dut.ts_view_y), static_cast<uint64_t>(dut.ts_view_z), static_cast<uint64_t>(dut.ts_light0_x), static_cast<uint64_t>(dut.ts_light0_y), static_cast<uint64_t>(dut.ts_light0_z), static_cast<uint64_t>(dut.mirrored), static_cast<uint64_t>(dut.degenerate), static_cast<uint64_t>(dut.zero_uv), static_cast<uint64_t>(dut.zero_area), static_cast<uint64_t>(dut.parallel)};
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
