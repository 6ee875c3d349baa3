// ernst: light of a bump-mapped pixel by matrix, normalisation and Cartesian dot products
// made by fixpath 0.1.0; Ernst et al. 1998, as seed 001 (Lee et al.) counts it in Table 1 and section 4.3
//   normalise=divide divider=non-restoring root=digits frac_bits=16 guard_bits=2 rounding=half-up
//   table_addr_bits=10 scheme=direct recip_addr_bits=auto root_addr_bits=auto highlight=on
//   specular_addr_bits=10 light_scheme=direct light_bits=16 ambient=0.1 diffuse=0.6 specular=0.3
//   exponent=32 period_ps=5000 stages=auto rom=block
// latency 33 cycles, interval 1 cycle; tables read on the clock
// absolute errors against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   intensity: mean 7.10e-5, largest seen 4.39e-3 (287.8 ulp) at l_x=-17621 l_y=-12812 l_z=61809 h_x=-42849 h_y=10989 h_z=48354 n_x=-27841 n_y=44144 n_z=39637 t_x=42357 t_y=-15868 t_z=47424 b_x=41542 b_y=45765 b_z=-21790 p_x=6319 p_y=-31430 p_z=57160
//   diffuse: mean 7.90e-6, largest seen 3.38e-5 (2.2 ulp) at l_x=8189 l_y=37211 l_z=53322 h_x=11330 h_y=-3065 h_z=64476 n_x=11403 n_y=-35489 n_z=53903 t_x=59242 t_y=-15956 t_z=-23038 b_x=25599 b_y=52734 b_z=29304 p_x=3824 p_y=43866 p_z=48539
//   specular: mean 6.51e-5, largest seen 4.37e-3 (286.6 ulp) at l_x=-17621 l_y=-12812 l_z=61809 h_x=-42849 h_y=10989 h_z=48354 n_x=-27841 n_y=44144 n_z=39637 t_x=42357 t_y=-15868 t_z=47424 b_x=41542 b_y=45765 b_z=-21790 p_x=6319 p_y=-31430 p_z=57160
//   dot_l: mean 5.51e-6, largest seen 2.58e-5 (1.7 ulp) at l_x=8189 l_y=37211 l_z=53322 h_x=11330 h_y=-3065 h_z=64476 n_x=11403 n_y=-35489 n_z=53903 t_x=59242 t_y=-15956 t_z=-23038 b_x=25599 b_y=52734 b_z=29304 p_x=3824 p_y=43866 p_z=48539
//   dot_h: mean 5.55e-6, largest seen 2.64e-5 (1.7 ulp) at l_x=28436 l_y=58436 l_z=-8465 h_x=56347 h_y=29067 h_z=-16587 n_x=7268 n_y=55465 n_z=-34143 t_x=-16808 t_y=-31594 t_z=-54902 b_x=-62926 b_y=14846 b_z=10722 p_x=17769 p_y=-44293 p_z=44914
//   lt_angle: mean 5.96e-6 rad, largest seen 1.52e-5 rad at l_x=-46104 l_y=2218 l_z=46524 h_x=-34894 h_y=-9840 h_z=54594 n_x=-8835 n_y=57118 n_z=30893 t_x=27988 t_y=31483 t_z=-50204 b_x=-58597 b_y=6425 b_z=-28637 p_x=-41292 p_y=29455 p_z=41501
//   lt_dot: mean 7.58e-6, largest seen 1.60e-5 at l_x=-51507 l_y=24581 l_z=-32215 h_x=-48499 h_y=-39070 h_z=-20406 n_x=-49786 n_y=-42007 n_z=7192 t_x=-40759 t_y=43701 t_z=-26905 b_x=12449 b_y=-24912 b_z=-59324 p_x=18646 p_y=26903 p_z=56776
//   lt_x: mean 3.93e-6, largest seen 1.06e-5 (0.7 ulp) at l_x=-15279 l_y=5067 l_z=63528 h_x=29170 h_y=-18014 h_z=55853 n_x=53184 n_y=30871 n_z=22658 t_x=9050 t_y=-47812 t_z=43899 b_x=37209 b_y=-32496 b_z=-43064 p_x=30395 p_y=-14945 p_z=56105
//   lt_y: mean 3.92e-6, largest seen 1.06e-5 (0.7 ulp) at l_x=-33544 l_y=8570 l_z=55645 h_x=3237 h_y=45027 h_z=47509 n_x=51579 n_y=35193 n_z=-19899 t_x=-23525 t_y=-107 t_z=-61168 b_x=-32880 b_y=55285 b_z=12549 p_x=35175 p_y=37290 p_z=40831
//   lt_z: mean 3.90e-6, largest seen 1.06e-5 (0.7 ulp) at l_x=60216 l_y=-731 l_z=25854 h_x=28155 h_y=-38009 h_z=45360 n_x=49800 n_y=-42419 n_z=3954 t_x=-7689 t_y=-2967 t_z=65016 b_x=-41903 b_y=-49868 b_z=-7231 p_x=38689 p_y=13334 p_z=51189
//   ht_angle: mean 5.97e-6 rad, largest seen 1.55e-5 rad at l_x=-42413 l_y=5315 l_z=-49678 h_x=-49190 h_y=10077 h_z=-42117 n_x=31825 n_y=43565 n_z=-37205 t_x=52333 t_y=-39424 t_z=-1398 b_x=-23310 b_y=-29031 b_z=-53933 p_x=41501 p_y=24164 p_z=44595
//   ht_dot: mean 7.59e-6, largest seen 1.61e-5 at l_x=39313 l_y=33020 l_z=40732 h_x=45349 h_y=44689 h_z=15535 n_x=-37342 n_y=44334 n_z=30579 t_x=53162 t_y=24386 t_z=29565 b_x=8622 b_y=41651 b_z=-49858 p_x=-25251 p_y=-37777 p_z=47226
//   ht_x: mean 3.92e-6, largest seen 1.07e-5 (0.7 ulp) at l_x=39149 l_y=-824 l_z=-52551 h_x=24132 h_y=-60683 h_z=-5494 n_x=-27035 n_y=-45260 n_z=-38931 t_x=-59525 t_y=17166 t_z=21378 b_x=-4566 b_y=44180 b_z=-48190 p_x=-12132 p_y=43147 p_z=47813
//   ht_y: mean 3.92e-6, largest seen 1.08e-5 (0.7 ulp) at l_x=32246 l_y=-33688 l_z=-46046 h_x=26934 h_y=-37639 h_z=-46399 n_x=15761 n_y=17121 n_z=-61265 t_x=59086 t_y=-27325 t_z=7564 b_x=-23568 b_y=-57054 b_z=-22007 p_x=-27119 p_y=36491 p_z=47201
//   ht_z: mean 3.92e-6, largest seen 1.08e-5 (0.7 ulp) at l_x=-37898 l_y=-11533 l_z=52209 h_x=-54011 h_y=-33479 h_z=-16030 n_x=-19265 n_y=-61659 n_z=-11046 t_x=-4008 t_y=12746 t_z=-64159 b_x=62512 b_y=-18185 b_z=-7518 p_x=10839 p_y=-28061 p_z=58224
// stated bound on each dot: 7.02e-5
// stated bound on each diffuse: 8.02e-5
// stated bound on each specular: 5.24e-3
// stated bound on each intensity: 5.33e-3
// stated bound on each component: 1.81e-5
// bounds hold for L and H in the texture frame, and N', from 1/2 to 2 long
//
// Verilator's harness of ernst: feeds vectors from a file, or from the standard input if
// there is none, with stalls and gaps now and then and a reset in mid-stream, and compares every
// bit of every output and the latency. The last line says PASS or FAIL; the status is 0 or 1.
#include "Vernst.h"
#include "verilated.h"
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <vector>

static constexpr int kInputs = 18;
static constexpr int kOutputs = 3;
static constexpr int kFields = kInputs + kOutputs;
static constexpr int kLatency = 33;
static constexpr uint64_t kShown = 10;  // of the mismatches
static const char* const kNames[] = {"intensity", "diffuse", "specular"};

// Hexadecimal words, 21 a line.
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
    Vernst dut{&context};
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
        put(dut.l_x, (in.valid ? in.words[0] : ~in.words[0]) & UINT64_C(0x3ffff));
        put(dut.l_y, (in.valid ? in.words[1] : ~in.words[1]) & UINT64_C(0x3ffff));
        put(dut.l_z, (in.valid ? in.words[2] : ~in.words[2]) & UINT64_C(0x3ffff));
        put(dut.h_x, (in.valid ? in.words[3] : ~in.words[3]) & UINT64_C(0x3ffff));
        put(dut.h_y, (in.valid ? in.words[4] : ~in.words[4]) & UINT64_C(0x3ffff));
        put(dut.h_z, (in.valid ? in.words[5] : ~in.words[5]) & UINT64_C(0x3ffff));
        put(dut.n_x, (in.valid ? in.words[6] : ~in.words[6]) & UINT64_C(0x3ffff));
        put(dut.n_y, (in.valid ? in.words[7] : ~in.words[7]) & UINT64_C(0x3ffff));
        put(dut.n_z, (in.valid ? in.words[8] : ~in.words[8]) & UINT64_C(0x3ffff));
        put(dut.t_x, (in.valid ? in.words[9] : ~in.words[9]) & UINT64_C(0x3ffff));
        put(dut.t_y, (in.valid ? in.words[10] : ~in.words[10]) & UINT64_C(0x3ffff));
        put(dut.t_z, (in.valid ? in.words[11] : ~in.words[11]) & UINT64_C(0x3ffff));
        put(dut.b_x, (in.valid ? in.words[12] : ~in.words[12]) & UINT64_C(0x3ffff));
        put(dut.b_y, (in.valid ? in.words[13] : ~in.words[13]) & UINT64_C(0x3ffff));
        put(dut.b_z, (in.valid ? in.words[14] : ~in.words[14]) & UINT64_C(0x3ffff));
        put(dut.p_x, (in.valid ? in.words[15] : ~in.words[15]) & UINT64_C(0x3ffff));
        put(dut.p_y, (in.valid ? in.words[16] : ~in.words[16]) & UINT64_C(0x3ffff));
        put(dut.p_z, (in.valid ? in.words[17] : ~in.words[17]) & UINT64_C(0x3ffff));
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
            const uint64_t got[] = {static_cast<uint64_t>(dut.intensity), static_cast<uint64_t>(dut.diffuse), static_cast<uint64_t>(dut.specular)};
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
