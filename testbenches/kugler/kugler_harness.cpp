// kugler: light of a bump-mapped pixel by rotations and light maps, without dot products
// made by fixpath 0.1.0; Kugler 1998 (IMEM), as seed 001 (Lee et al.) describes it; largely a reconstruction
//   conversion=table tilt_addr_bits=14 map_angle_bits=8 map_addr_bits=12 angle_bits=16
//   table_addr_bits=10 scheme=direct quarter_wave=off frac_bits=16 guard_bits=2 rounding=half-up
//   recip_addr_bits=auto atan_addr_bits=auto cordic_iterations=auto highlight=on light_bits=16
//   ambient=0.1 diffuse=0.6 specular=0.3 exponent=32 period_ps=5000 stages=auto rom=block
// latency 21 cycles, interval 1 cycle; tables read on the clock
// absolute errors against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   intensity: mean 1.64e-2, largest seen 3.21e-1 (21034.8 ulp) at n_x=-56529 n_y=31196 n_z=11234 psi=16437 phi_p=60731 theta_p=6337 phi_l=24836 theta_l=12014 phi_h=33009 theta_h=16304
//   diffuse: mean 1.43e-2, largest seen 1.61e-1 (10548.1 ulp) at n_x=64337 n_y=68 n_z=-12481 psi=46469 phi_p=59889 theta_p=8345 phi_l=60553 theta_l=24577 phi_h=60753 theta_h=28326
//   specular: mean 3.33e-3, largest seen 2.10e-1 (13738.9 ulp) at n_x=-56529 n_y=31196 n_z=11234 psi=16437 phi_p=60731 theta_p=6337 phi_l=24836 theta_l=12014 phi_h=33009 theta_h=16304
//   pw_angle: mean 6.11e-2 rad, largest seen 1.66e-1 rad at n_x=-20635 n_y=-14506 n_z=-60487 psi=49532 phi_p=56925 theta_p=9312 phi_l=47085 theta_l=24477 phi_h=52484 theta_h=24320
//   pw_dot: mean 6.11e-2, largest seen 1.66e-1 at n_x=-20635 n_y=-14506 n_z=-60487 psi=49532 phi_p=56925 theta_p=9312 phi_l=47085 theta_l=24477 phi_h=52484 theta_h=24320
//   pw_x: mean 2.72e-2, largest seen 1.50e-1 at n_x=-40953 n_y=22153 n_z=46120 psi=61767 phi_p=36536 theta_p=8148 phi_l=60944 theta_l=4014 phi_h=33548 theta_h=9549
//   pw_y: mean 2.71e-2, largest seen 1.47e-1 at n_x=13068 n_y=52261 n_z=-37322 psi=50906 phi_p=20746 theta_p=8211 phi_l=13848 theta_l=18740 phi_h=19374 theta_h=27605
//   pw_z: mean 3.70e-2, largest seen 1.56e-1 at n_x=58525 n_y=-14807 n_z=25506 psi=44588 phi_p=12702 theta_p=8159 phi_l=49639 theta_l=20508 phi_h=63118 theta_h=22796
//   pl_angle: mean 8.82e-2 rad, largest seen 2.91e-1 rad at n_x=-62258 n_y=15402 n_z=13480 psi=25126 phi_p=44526 theta_p=6092 phi_l=34830 theta_l=12436 phi_h=33197 theta_h=20245
//   pl_dot: mean 8.82e-2, largest seen 2.90e-1 at n_x=-62258 n_y=15402 n_z=13480 psi=25126 phi_p=44526 theta_p=6092 phi_l=34830 theta_l=12436 phi_h=33197 theta_h=20245
//   pl_x: mean 4.70e-2, largest seen 2.78e-1 at n_x=36200 n_y=-53003 n_z=-13238 psi=14755 phi_p=47780 theta_p=7407 phi_l=57722 theta_l=28642 phi_h=58499 theta_h=19711
//   pl_y: mean 3.86e-2, largest seen 1.99e-1 at n_x=1054 n_y=243 n_z=65527 psi=4485 phi_p=44708 theta_p=8256 phi_l=16693 theta_l=28786 phi_h=40236 theta_h=23869
//   pl_z: mean 4.65e-2, largest seen 2.53e-1 at n_x=-21222 n_y=60550 n_z=-13354 psi=8628 phi_p=51032 theta_p=3342 phi_l=50666 theta_l=26736 phi_h=12630 theta_h=28946
//   ph_angle: mean 8.83e-2 rad, largest seen 2.92e-1 rad at n_x=23355 n_y=8851 n_z=60590 psi=55836 phi_p=32370 theta_p=6217 phi_l=26943 theta_l=19308 phi_h=31160 theta_h=12227
//   ph_dot: mean 8.83e-2, largest seen 2.91e-1 at n_x=23355 n_y=8851 n_z=60590 psi=55836 phi_p=32370 theta_p=6217 phi_l=26943 theta_l=19308 phi_h=31160 theta_h=12227
//   ph_x: mean 4.70e-2, largest seen 2.42e-1 at n_x=40289 n_y=36933 n_z=-36161 psi=5281 phi_p=51702 theta_p=5800 phi_l=12406 theta_l=11093 phi_h=11666 theta_h=24712
//   ph_y: mean 3.87e-2, largest seen 1.90e-1 at n_x=18685 n_y=41876 n_z=-46821 psi=56218 phi_p=58881 theta_p=9312 phi_l=60146 theta_l=20332 phi_h=65052 theta_h=17648
//   ph_z: mean 4.67e-2, largest seen 2.45e-1 at n_x=63088 n_y=-17640 n_z=1940 psi=34649 phi_p=1283 theta_p=7197 phi_l=57191 theta_l=29307 phi_h=60648 theta_h=22533
// no bound is stated: near a pole, a cell of a map has azimuths of the whole turn in it: no cell size bounds the light
//
// Verilator's harness of kugler: feeds vectors from a file, or from the standard input if
// there is none, with stalls and gaps now and then and a reset in mid-stream, and compares every
// bit of every output and the latency. The last line says PASS or FAIL; the status is 0 or 1.
#include "Vkugler.h"
#include "verilated.h"
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <vector>

static constexpr int kInputs = 10;
static constexpr int kOutputs = 3;
static constexpr int kFields = kInputs + kOutputs;
static constexpr int kLatency = 21;
static constexpr uint64_t kShown = 10;  // of the mismatches
static const char* const kNames[] = {"intensity", "diffuse", "specular"};

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
    Vkugler dut{&context};
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
        put(dut.n_x, (in.valid ? in.words[0] : ~in.words[0]) & UINT64_C(0x3ffff));
        put(dut.n_y, (in.valid ? in.words[1] : ~in.words[1]) & UINT64_C(0x3ffff));
        put(dut.n_z, (in.valid ? in.words[2] : ~in.words[2]) & UINT64_C(0x3ffff));
        put(dut.psi, (in.valid ? in.words[3] : ~in.words[3]) & UINT64_C(0xffff));
        put(dut.phi_p, (in.valid ? in.words[4] : ~in.words[4]) & UINT64_C(0xffff));
        put(dut.theta_p, (in.valid ? in.words[5] : ~in.words[5]) & UINT64_C(0xffff));
        put(dut.phi_l, (in.valid ? in.words[6] : ~in.words[6]) & UINT64_C(0xffff));
        put(dut.theta_l, (in.valid ? in.words[7] : ~in.words[7]) & UINT64_C(0xffff));
        put(dut.phi_h, (in.valid ? in.words[8] : ~in.words[8]) & UINT64_C(0xffff));
        put(dut.theta_h, (in.valid ? in.words[9] : ~in.words[9]) & UINT64_C(0xffff));
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
