// basis: binormal and tangent from normal and tangent: N x CT, normalised, x N
// made by fixpath 0.1.0; seed 002 (GL_NV_texgen_emboss), section 2.10.4
//   component_bits=16 guard_bits=0 norm_bits=18 dot_frac_bits=20 root_scheme=linear
//   root_addr_bits=9 root_frac_bits=18 rounding=half-up period_ps=5000 stages=auto rom=block
// latency 17 cycles, interval 1 cycle; tables read on the clock
// absolute errors against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   t_angle: mean 2.57e-5 rad, largest seen 9.63e-5 rad at normal_x=8380 normal_y=9641 normal_z=-7349 ct_x=13930 ct_y=3067 ct_z=4821
//   t_dot: mean 3.53e-5, largest seen 9.39e-5 at normal_x=12976 normal_y=12042 normal_z=-8607 ct_x=3888 ct_y=-10225 ct_z=8359
//   t_x: mean 1.77e-5, largest seen 7.84e-5 (1.3 ulp) at normal_x=9018 normal_y=13214 normal_z=12085 ct_x=-15544 ct_y=-6937 ct_z=8164
//   t_y: mean 1.77e-5, largest seen 7.49e-5 (1.2 ulp) at normal_x=-17534 normal_y=-897 normal_z=-9433 ct_x=8013 ct_y=-16499 ct_z=5940
//   t_z: mean 1.78e-5, largest seen 7.66e-5 (1.3 ulp) at normal_x=12976 normal_y=12042 normal_z=-8607 ct_x=3888 ct_y=-10225 ct_z=8359
//   bn_angle: mean 2.32e-5 rad, largest seen 5.60e-5 rad at normal_x=-10642 normal_y=-5666 normal_z=-5953 ct_x=1726 ct_y=-1464 ct_z=13894
//   bn_dot: mean 2.95e-5, largest seen 5.63e-5 at normal_x=-3329 normal_y=13424 normal_z=8156 ct_x=-4182 ct_y=-3328 ct_z=18276
//   bn_x: mean 1.53e-5, largest seen 3.77e-5 (0.6 ulp) at normal_x=-15816 normal_y=-754 normal_z=-9817 ct_x=-2394 ct_y=16948 ct_z=5363
//   bn_y: mean 1.53e-5, largest seen 3.75e-5 (0.6 ulp) at normal_x=16418 normal_y=-5802 normal_z=-2767 ct_x=-7596 ct_y=-14180 ct_z=-5075
//   bn_z: mean 1.54e-5, largest seen 3.67e-5 (0.6 ulp) at normal_x=4888 normal_y=-14943 normal_z=10350 ct_x=-4569 ct_y=10830 ct_z=11114
//   degenerate: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at normal_x=-2531 normal_y=7271 normal_z=-13448 ct_x=-2894 ct_y=-19246 ct_z=1152
// stated bound on each binormal: 8.03e-5
// stated bound on each tangent: 3.31e-4
// stated bound on each flag: 0.00e0
// renamed, since a language or another word has the name:
//   bn_x is bn_x_2
//   bn_y is bn_y_2
//   bn_z is bn_z_2
//
// Verilator's harness of basis: feeds vectors from a file, or from the standard input if
// there is none, with stalls and gaps now and then and a reset in mid-stream, and compares every
// bit of every output and the latency. The last line says PASS or FAIL; the status is 0 or 1.
#include "Vbasis.h"
#include "verilated.h"
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <vector>

static constexpr int kInputs = 6;
static constexpr int kOutputs = 7;
static constexpr int kFields = kInputs + kOutputs;
static constexpr int kLatency = 17;
static constexpr uint64_t kShown = 10;  // of the mismatches
static const char* const kNames[] = {"t_x", "t_y", "t_z", "bn_x", "bn_y", "bn_z", "degenerate"};

// Hexadecimal words, 13 a line.
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
    Vbasis dut{&context};
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
        put(dut.normal_x, (in.valid ? in.words[0] : ~in.words[0]) & UINT64_C(0xffff));
        put(dut.normal_y, (in.valid ? in.words[1] : ~in.words[1]) & UINT64_C(0xffff));
        put(dut.normal_z, (in.valid ? in.words[2] : ~in.words[2]) & UINT64_C(0xffff));
        put(dut.ct_x, (in.valid ? in.words[3] : ~in.words[3]) & UINT64_C(0xffff));
        put(dut.ct_y, (in.valid ? in.words[4] : ~in.words[4]) & UINT64_C(0xffff));
        put(dut.ct_z, (in.valid ? in.words[5] : ~in.words[5]) & UINT64_C(0xffff));
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
            const uint64_t got[] = {static_cast<uint64_t>(dut.t_x), static_cast<uint64_t>(dut.t_y), static_cast<uint64_t>(dut.t_z), static_cast<uint64_t>(dut.bn_x), static_cast<uint64_t>(dut.bn_y), static_cast<uint64_t>(dut.bn_z), static_cast<uint64_t>(dut.degenerate)};
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
