// combine: diffuse light plus the differences of height samples: the emboss of one to eight lights
// made by fixpath 0.1.0; seed 000 (US 6,980,218), the texture combination of the emboss; seed 003 has the same text
//   filter=bilinear lights=1 difference=undisplaced-displaced channel_bits=8 fraction_bits=8
//   guard_bits=4 gain_log2=0 rounding=half-up period_ps=5000 stages=auto rom=block
// latency 4 cycles, interval 1 cycle; no tables
// absolute errors against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   out_r: mean 1.94e-1, largest seen 5.91e-1 (0.6 ulp) at h_00=188 h_10=50 h_01=155 h_11=31 h_a=110 h_b=236 d0_00=43 d0_10=113 d0_01=189 d0_11=244 d0_a=153 d0_b=59 r=146 g=32 b=19
//   out_g: mean 1.95e-1, largest seen 5.98e-1 (0.6 ulp) at h_00=20 h_10=11 h_01=211 h_11=127 h_a=6 h_b=211 d0_00=155 d0_10=38 d0_01=7 d0_11=98 d0_a=114 d0_b=229 r=133 g=105 b=125
//   out_b: mean 1.94e-1, largest seen 5.98e-1 (0.6 ulp) at h_00=20 h_10=11 h_01=211 h_11=127 h_a=6 h_b=211 d0_00=155 d0_10=38 d0_01=7 d0_11=98 d0_a=114 d0_b=229 r=133 g=105 b=125
// stated bound on each channel: 6.25e-1
//
// Verilator's harness of combine: feeds vectors from a file, or from the standard input if
// there is none, with stalls and gaps now and then and a reset in mid-stream, and compares every
// bit of every output and the latency. The last line says PASS or FAIL; the status is 0 or 1.
#include "Vcombine.h"
#include "verilated.h"
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <vector>

static constexpr int kInputs = 15;
static constexpr int kOutputs = 3;
static constexpr int kFields = kInputs + kOutputs;
static constexpr int kLatency = 4;
static constexpr uint64_t kShown = 10;  // of the mismatches
static const char* const kNames[] = {"out_r", "out_g", "out_b"};

// Hexadecimal words, 18 a line.
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
    Vcombine dut{&context};
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
        put(dut.h_00, (in.valid ? in.words[0] : ~in.words[0]) & UINT64_C(0xff));
        put(dut.h_10, (in.valid ? in.words[1] : ~in.words[1]) & UINT64_C(0xff));
        put(dut.h_01, (in.valid ? in.words[2] : ~in.words[2]) & UINT64_C(0xff));
        put(dut.h_11, (in.valid ? in.words[3] : ~in.words[3]) & UINT64_C(0xff));
        put(dut.h_a, (in.valid ? in.words[4] : ~in.words[4]) & UINT64_C(0xff));
        put(dut.h_b, (in.valid ? in.words[5] : ~in.words[5]) & UINT64_C(0xff));
        put(dut.d0_00, (in.valid ? in.words[6] : ~in.words[6]) & UINT64_C(0xff));
        put(dut.d0_10, (in.valid ? in.words[7] : ~in.words[7]) & UINT64_C(0xff));
        put(dut.d0_01, (in.valid ? in.words[8] : ~in.words[8]) & UINT64_C(0xff));
        put(dut.d0_11, (in.valid ? in.words[9] : ~in.words[9]) & UINT64_C(0xff));
        put(dut.d0_a, (in.valid ? in.words[10] : ~in.words[10]) & UINT64_C(0xff));
        put(dut.d0_b, (in.valid ? in.words[11] : ~in.words[11]) & UINT64_C(0xff));
        put(dut.r, (in.valid ? in.words[12] : ~in.words[12]) & UINT64_C(0xff));
        put(dut.g, (in.valid ? in.words[13] : ~in.words[13]) & UINT64_C(0xff));
        put(dut.b, (in.valid ? in.words[14] : ~in.words[14]) & UINT64_C(0xff));
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
            const uint64_t got[] = {static_cast<uint64_t>(dut.out_r), static_cast<uint64_t>(dut.out_g), static_cast<uint64_t>(dut.out_b)};
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
