// bump: light of a bump-mapped pixel from light, halfway vector, normal and bump vector
// made by fixpath 0.1.0; seed 001 (Lee et al.), Fig. 8; the turn psi and the exact pipelines are this project's
//   pipeline=exact-polar conversion=table angle_bits=16 table_addr_bits=10 scheme=direct
//   quarter_wave=off frac_bits=16 guard_bits=2 rounding=half-up sincos_addr_bits=auto
//   asin_addr_bits=auto recip_addr_bits=auto atan_addr_bits=auto prop_addr_bits=auto
//   cos_addr_bits=auto recip_int_bits=8 atan_int_bits=auto quadrants=full cordic_iterations=auto
//   highlight=on diffuse_addr_bits=10 specular_addr_bits=10 light_scheme=direct light_bits=16
//   ambient=0.1 diffuse=0.6 specular=0.3 exponent=32 period_ps=5000 stages=auto rom=block
// latency 24 cycles, interval 1 cycle; tables read on the clock
// absolute errors against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   intensity: mean 4.50e-4, largest seen 8.09e-3 (529.9 ulp) at phi_l=54099 theta_l=21061 phi_h=60333 theta_h=25870 phi_n=4085 theta_n=24243 psi=15789 phi_p=37530 theta_p=7850
//   diffuse: mean 3.83e-4, largest seen 4.02e-3 (263.2 ulp) at phi_l=44654 theta_l=8576 phi_h=60159 theta_h=5510 phi_n=58665 theta_n=10045 psi=11801 phi_p=60790 theta_p=4186
//   specular: mean 1.09e-4, largest seen 7.98e-3 (522.8 ulp) at phi_l=40708 theta_l=14134 phi_h=34659 theta_h=13276 phi_n=35527 theta_n=15280 psi=31916 phi_p=11259 theta_p=2671
//   dot_l: mean 1.24e-3, largest seen 6.37e-3 (417.4 ulp) at phi_l=61704 theta_l=22170 phi_h=4275 theta_h=14080 phi_n=20110 theta_n=22175 psi=22018 phi_p=55143 theta_p=8416
//   dot_h: mean 1.25e-3, largest seen 6.38e-3 (417.8 ulp) at phi_l=40990 theta_l=19166 phi_h=52190 theta_h=15291 phi_n=57641 theta_n=20094 psi=62778 phi_p=9870 theta_p=8515
//   lt_angle: mean 1.43e-3 rad, largest seen 4.45e-3 rad at phi_l=43319 theta_l=16515 phi_h=51482 theta_h=13337 phi_n=3571 theta_n=9794 psi=27030 phi_p=28221 theta_p=6758
//   lt_dot: mean 1.43e-3, largest seen 4.45e-3 at phi_l=43319 theta_l=16515 phi_h=51482 theta_h=13337 phi_n=3571 theta_n=9794 psi=27030 phi_p=28221 theta_p=6758
//   lt_x: mean 7.74e-4, largest seen 4.05e-3 at phi_l=6884 theta_l=16156 phi_h=11810 theta_h=14024 phi_n=5223 theta_n=13921 psi=46897 phi_p=28640 theta_p=7461
//   lt_y: mean 6.21e-4, largest seen 3.10e-3 at phi_l=40221 theta_l=13057 phi_h=11896 theta_h=1741 phi_n=6618 theta_n=8346 psi=32754 phi_p=13032 theta_p=5385
//   lt_z: mean 7.41e-4, largest seen 4.08e-3 at phi_l=55938 theta_l=23167 phi_h=56369 theta_h=21833 phi_n=7227 theta_n=16515 psi=2242 phi_p=14438 theta_p=4655
//   ht_angle: mean 1.43e-3 rad, largest seen 5.28e-3 rad at phi_l=53874 theta_l=21815 phi_h=50989 theta_h=16126 phi_n=18283 theta_n=2943 psi=27084 phi_p=38880 theta_p=9075
//   ht_dot: mean 1.43e-3, largest seen 5.28e-3 at phi_l=53874 theta_l=21815 phi_h=50989 theta_h=16126 phi_n=18283 theta_n=2943 psi=27084 phi_p=38880 theta_p=9075
//   ht_x: mean 7.83e-4, largest seen 4.09e-3 at phi_l=31111 theta_l=19790 phi_h=29735 theta_h=16324 phi_n=29676 theta_n=17022 psi=22911 phi_p=3532 theta_p=8126
//   ht_y: mean 6.21e-4, largest seen 3.21e-3 at phi_l=15384 theta_l=20283 phi_h=16010 theta_h=30916 phi_n=33483 theta_n=20732 psi=60970 phi_p=20741 theta_p=7238
//   ht_z: mean 7.39e-4, largest seen 4.45e-3 at phi_l=53874 theta_l=21815 phi_h=50989 theta_h=16126 phi_n=18283 theta_n=2943 psi=27084 phi_p=38880 theta_p=9075
// stated bound on each dot: 2.73e-2
// stated bound on each diffuse: 1.67e-2
// stated bound on each specular: 1.81e-1
// stated bound on each intensity: 1.97e-1
// stated bound on the angle: 1.82e-2 rad
//
// Verilator's harness of bump: feeds vectors from a file, or from the standard input if
// there is none, with stalls and gaps now and then and a reset in mid-stream, and compares every
// bit of every output and the latency. The last line says PASS or FAIL; the status is 0 or 1.
#include "Vbump.h"
#include "verilated.h"
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <vector>

static constexpr int kInputs = 9;
static constexpr int kOutputs = 3;
static constexpr int kFields = kInputs + kOutputs;
static constexpr int kLatency = 24;
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
    Vbump dut{&context};
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
