// kim: light of a bump-mapped pixel by a matrix of sines and cosines and polar dot products
// made by fixpath 0.1.0; Kim et al. 2001: eqs (3), (4) of seed 001 (Lee et al.); the set-up is a reconstruction
//   conversion=table angle_bits=16 table_addr_bits=10 scheme=direct quarter_wave=off frac_bits=16
//   guard_bits=2 rounding=half-up sincos_addr_bits=auto recip_addr_bits=auto atan_addr_bits=auto
//   cordic_iterations=auto highlight=on diffuse_addr_bits=10 specular_addr_bits=10
//   light_scheme=direct light_bits=16 ambient=0.1 diffuse=0.6 specular=0.3 exponent=32
//   period_ps=5000 stages=auto rom=block
// latency 30 cycles, interval 1 cycle; tables read on the clock
// absolute errors against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   intensity: mean 6.91e-4, largest seen 1.28e-2 (836.5 ulp) at phi_l=12249 theta_l=10042 phi_h=25129 theta_h=12990 phi_n=27856 theta_n=18250 psi=18706 phi_p=19124 theta_p=3769
//   diffuse: mean 5.92e-4, largest seen 7.09e-3 (464.8 ulp) at phi_l=5887 theta_l=21190 phi_h=20694 theta_h=21693 phi_n=7057 theta_n=377 psi=41054 phi_p=32253 theta_p=7036
//   specular: mean 1.54e-4, largest seen 1.15e-2 (756.4 ulp) at phi_l=46792 theta_l=23943 phi_h=48621 theta_h=15295 phi_n=56540 theta_n=7516 psi=771 phi_p=53306 theta_p=8323
//   dot_l: mean 1.94e-3, largest seen 1.17e-2 (766.0 ulp) at phi_l=5887 theta_l=21190 phi_h=20694 theta_h=21693 phi_n=7057 theta_n=377 psi=41054 phi_p=32253 theta_p=7036
//   dot_h: mean 1.93e-3, largest seen 1.09e-2 (713.0 ulp) at phi_l=60553 theta_l=18372 phi_h=64636 theta_h=22235 phi_n=8005 theta_n=19253 psi=1559 phi_p=20130 theta_p=8069
//   lt_angle: mean 2.77e-3 rad, largest seen 7.77e-3 rad at phi_l=6915 theta_l=10368 phi_h=4641 theta_h=3798 phi_n=44602 theta_n=12480 psi=59670 phi_p=22351 theta_p=3078
//   lt_dot: mean 2.77e-3, largest seen 7.77e-3 at phi_l=6915 theta_l=10368 phi_h=4641 theta_h=3798 phi_n=44602 theta_n=12480 psi=59670 phi_p=22351 theta_p=3078
//   lt_x: mean 1.43e-3, largest seen 7.31e-3 at phi_l=3004 theta_l=11455 phi_h=6745 theta_h=15411 phi_n=16385 theta_n=5769 psi=61008 phi_p=44796 theta_p=5705
//   lt_y: mean 1.26e-3, largest seen 6.21e-3 at phi_l=58622 theta_l=14345 phi_h=63015 theta_h=26871 phi_n=27904 theta_n=24597 psi=39862 phi_p=34182 theta_p=8142
//   lt_z: mean 1.47e-3, largest seen 6.89e-3 at phi_l=46077 theta_l=10290 phi_h=47299 theta_h=13859 phi_n=55937 theta_n=20227 psi=54458 phi_p=65410 theta_p=4451
//   ht_angle: mean 2.77e-3 rad, largest seen 7.83e-3 rad at phi_l=27736 theta_l=15792 phi_h=15742 theta_h=17078 phi_n=13120 theta_n=9730 psi=31698 phi_p=62952 theta_p=6764
//   ht_dot: mean 2.77e-3, largest seen 7.83e-3 at phi_l=27736 theta_l=15792 phi_h=15742 theta_h=17078 phi_n=13120 theta_n=9730 psi=31698 phi_p=62952 theta_p=6764
//   ht_x: mean 1.43e-3, largest seen 6.94e-3 at phi_l=60765 theta_l=22077 phi_h=12545 theta_h=23229 phi_n=26302 theta_n=28297 psi=58283 phi_p=51185 theta_p=7747
//   ht_y: mean 1.26e-3, largest seen 5.92e-3 at phi_l=17506 theta_l=13432 phi_h=12930 theta_h=16780 phi_n=13695 theta_n=13345 psi=2824 phi_p=40130 theta_p=3617
//   ht_z: mean 1.46e-3, largest seen 6.74e-3 at phi_l=15954 theta_l=3967 phi_h=34558 theta_h=10628 phi_n=23439 theta_n=21371 psi=29040 phi_p=61493 theta_p=6921
// stated bound on each dot: 8.61e-2
// stated bound on each diffuse: 5.20e-2
// stated bound on each specular: 2.88e-1
// stated bound on each intensity: 3.40e-1
// stated bound on the angle: 7.10e-2 rad
//
// Verilator's harness of kim: feeds vectors from a file, or from the standard input if
// there is none, with stalls and gaps now and then and a reset in mid-stream, and compares every
// bit of every output and the latency. The last line says PASS or FAIL; the status is 0 or 1.
#include "Vkim.h"
#include "verilated.h"
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <vector>

static constexpr int kInputs = 9;
static constexpr int kOutputs = 3;
static constexpr int kFields = kInputs + kOutputs;
static constexpr int kLatency = 30;
static constexpr uint64_t kShown = 10;  // of the mismatches
static const char* const kNames[] = {"intensity", "diffuse", "specular"};

// Hexadecimal words, 12 a line.
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
    Vkim dut{&context};
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
        put(dut.phi_l, (in.valid ? in.words[0] : ~in.words[0]) & UINT64_C(0xffff));
        put(dut.theta_l, (in.valid ? in.words[1] : ~in.words[1]) & UINT64_C(0xffff));
        put(dut.phi_h, (in.valid ? in.words[2] : ~in.words[2]) & UINT64_C(0xffff));
        put(dut.theta_h, (in.valid ? in.words[3] : ~in.words[3]) & UINT64_C(0xffff));
        put(dut.phi_n, (in.valid ? in.words[4] : ~in.words[4]) & UINT64_C(0xffff));
        put(dut.theta_n, (in.valid ? in.words[5] : ~in.words[5]) & UINT64_C(0xffff));
        put(dut.psi, (in.valid ? in.words[6] : ~in.words[6]) & UINT64_C(0xffff));
        put(dut.phi_p, (in.valid ? in.words[7] : ~in.words[7]) & UINT64_C(0xffff));
        put(dut.theta_p, (in.valid ? in.words[8] : ~in.words[8]) & UINT64_C(0xffff));
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
