// emboss: texture coordinates displaced by the direction of a light, for embossing
// made by fixpath 0.1.0; US 6,980,218; US 7,307,640; GL_NV_texgen_emboss
//   setting=gx frame=auto normalise_basis=auto s_vector=auto l_sign=light-vertex t_sign=auto
//   scale_q=auto constants=auto ks=1 kt=1 input20=off component_bits=16 matrix_bits=16
//   matrix_int_bits=2 position_bits=28 position_frac_bits=15 guard_bits=4 norm_bits=18
//   dot_frac_bits=20 root_scheme=linear root_addr_bits=9 root_frac_bits=18 constant_int_bits=auto
//   constant_frac_bits=auto texture_int_bits=6 texture_frac_bits=18 overflow=saturate
//   rounding=half-up texture_size=256 light=0 source=0 destination=1 period_ps=5000 stages=auto
//   rom=block
// latency 14 cycles, interval 1 cycle; tables read on the clock
// errors, absolute unless a scale is named, against the golden model of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst case:
//   ds_texels: mean 5.15e-4 texel, largest seen 4.51e-3 texel at m0_x=-442 m0_y=5407 m0_z=-14755 m1_x=-6142 m1_y=13528 m1_z=5141 m2_x=-14465 m2_y=-5909 m2_z=-1732 tangent_x=17214 tangent_y=6208 tangent_z=1262 binormal_x=6018 binormal_y=-11008 binormal_z=-11948 light_x=21336975 light_y=-15834250 light_z=24525963 vertex_x=21358568 vertex_y=-15697823 vertex_z=24496530 s0=3521428 t0=-2064244
//   ds_relative: mean 2.03e-6, largest seen 1.43e-5 over the vector's length times its factor, each at least 1/4, at m0_x=4132 m0_y=-131 m0_z=429 m1_x=133 m1_y=4154 m1_z=-11 m2_x=-428 m2_y=25 m2_z=4134 tangent_x=-10615 tangent_y=137 tangent_z=12480 binormal_x=-202 binormal_y=16379 binormal_z=-351 light_x=26912091 light_y=-19929090 light_z=-1678718 vertex_x=27451608 vertex_y=-19638454 vertex_z=-1458906 s0=-3142235 t0=-300807
//   ds: mean 2.01e-6, largest seen 1.76e-5 (4.6 ulp) at m0_x=-442 m0_y=5407 m0_z=-14755 m1_x=-6142 m1_y=13528 m1_z=5141 m2_x=-14465 m2_y=-5909 m2_z=-1732 tangent_x=17214 tangent_y=6208 tangent_z=1262 binormal_x=6018 binormal_y=-11008 binormal_z=-11948 light_x=21336975 light_y=-15834250 light_z=24525963 vertex_x=21358568 vertex_y=-15697823 vertex_z=24496530 s0=3521428 t0=-2064244
//   dt_texels: mean 5.17e-4 texel, largest seen 5.30e-3 texel at m0_x=16045 m0_y=65 m0_z=143 m1_x=-64 m1_y=16045 m1_z=-102 m2_x=-143 m2_y=101 m2_z=16045 tangent_x=8966 tangent_y=7112 tangent_z=-11725 binormal_x=-10345 binormal_y=-5688 binormal_z=-11360 light_x=-522867 light_y=-20208394 light_z=-19716311 vertex_x=689069 vertex_y=-19977840 vertex_z=-24049337 s0=3380560 t0=141093
//   dt_relative: mean 2.03e-6, largest seen 1.55e-5 over the vector's length times its factor, each at least 1/4, at m0_x=1817 m0_y=-3955 m0_z=169 m1_x=460 m1_y=27 m1_z=-4332 m2_x=3932 m2_y=1825 m2_z=429 tangent_x=6988 tangent_y=-14240 tangent_z=4101 binormal_x=-170 binormal_y=4457 binormal_z=15765 light_x=-9167663 light_y=7142069 light_z=-10596957 vertex_x=-8884124 vertex_y=7444365 vertex_z=-9525055 s0=2333965 t0=3659718
//   dt: mean 2.02e-6, largest seen 2.07e-5 (5.4 ulp) at m0_x=16045 m0_y=65 m0_z=143 m1_x=-64 m1_y=16045 m1_z=-102 m2_x=-143 m2_y=101 m2_z=16045 tangent_x=8966 tangent_y=7112 tangent_z=-11725 binormal_x=-10345 binormal_y=-5688 binormal_z=-11360 light_x=-522867 light_y=-20208394 light_z=-19716311 vertex_x=689069 vertex_y=-19977840 vertex_z=-24049337 s0=3380560 t0=141093
//   s1: mean 2.01e-6, largest seen 1.76e-5 (4.6 ulp) at m0_x=-442 m0_y=5407 m0_z=-14755 m1_x=-6142 m1_y=13528 m1_z=5141 m2_x=-14465 m2_y=-5909 m2_z=-1732 tangent_x=17214 tangent_y=6208 tangent_z=1262 binormal_x=6018 binormal_y=-11008 binormal_z=-11948 light_x=21336975 light_y=-15834250 light_z=24525963 vertex_x=21358568 vertex_y=-15697823 vertex_z=24496530 s0=3521428 t0=-2064244
//   t1: mean 2.02e-6, largest seen 2.07e-5 (5.4 ulp) at m0_x=16045 m0_y=65 m0_z=143 m1_x=-64 m1_y=16045 m1_z=-102 m2_x=-143 m2_y=101 m2_z=16045 tangent_x=8966 tangent_y=7112 tangent_z=-11725 binormal_x=-10345 binormal_y=-5688 binormal_z=-11360 light_x=-522867 light_y=-20208394 light_z=-19716311 vertex_x=689069 vertex_y=-19977840 vertex_z=-24049337 s0=3380560 t0=141093
//   degenerate: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at m0_x=4674 m0_y=5079 m0_z=-2162 m1_x=-3514 m1_y=4923 m1_z=3966 m2_x=-4257 m2_y=1512 m2_z=-5648 tangent_x=-2894 tangent_y=-19246 tangent_z=1152 binormal_x=-2531 binormal_y=7271 binormal_z=-13448 light_x=22420812 light_y=22017016 light_z=19624152 vertex_x=22724046 vertex_y=26548838 vertex_z=18617859 s0=2750663 t0=-1626897
// stated bound on each relative displacement (relative to the vector's length times its factor, each at least 1/4): 5.21e-5
// stated bound on each displacement: 1.15e-3
// stated bound on each displacement in texels: 2.93e-1
// stated bound on each coordinate: 1.15e-3
// stated bound on each flag and what is passed: 0.00e0
//
// Verilator harness of emboss.
// It feeds vectors from a file, or from standard input if no file is given, with random stalls
// and gaps and a reset in mid-stream, and compares every bit of every output and the latency.
// The last line says PASS or FAIL; the status is 0 or 1.
#include "Vemboss.h"
#include "verilated.h"
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <vector>

static constexpr int kInputs = 23;
static constexpr int kOutputs = 5;
static constexpr int kFields = kInputs + kOutputs;
static constexpr int kLatency = 14;
static constexpr uint64_t kShown = 10;  // of the mismatches
static const char* const kNames[] = {"ds", "dt", "s1", "t1", "degenerate"};

// Hexadecimal words, 28 per line.
class Vectors {
  public:
    explicit Vectors(FILE* file) : file_(file), buffer_(1 << 16) {}

    // False at the end. `cut` is set if a line is incomplete or malformed.
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
    Vemboss dut{&context};
    Vectors vectors(file);

    // Expected outputs, shifted along with the pipeline; the newest entry is at `head`.
    std::vector<Entry> pipe(kLatency + 1);
    int head = 0;
    // Words lost in the reset; they are sent again.
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
        // Stalls and gaps don't depend on the words.
        // The reset comes while the pipeline is full, during a stall, and takes effect despite it.
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
        put(dut.m0_x, (in.valid ? in.words[0] : ~in.words[0]) & UINT64_C(0xffff));
        put(dut.m0_y, (in.valid ? in.words[1] : ~in.words[1]) & UINT64_C(0xffff));
        put(dut.m0_z, (in.valid ? in.words[2] : ~in.words[2]) & UINT64_C(0xffff));
        put(dut.m1_x, (in.valid ? in.words[3] : ~in.words[3]) & UINT64_C(0xffff));
        put(dut.m1_y, (in.valid ? in.words[4] : ~in.words[4]) & UINT64_C(0xffff));
        put(dut.m1_z, (in.valid ? in.words[5] : ~in.words[5]) & UINT64_C(0xffff));
        put(dut.m2_x, (in.valid ? in.words[6] : ~in.words[6]) & UINT64_C(0xffff));
        put(dut.m2_y, (in.valid ? in.words[7] : ~in.words[7]) & UINT64_C(0xffff));
        put(dut.m2_z, (in.valid ? in.words[8] : ~in.words[8]) & UINT64_C(0xffff));
        put(dut.tangent_x, (in.valid ? in.words[9] : ~in.words[9]) & UINT64_C(0xffff));
        put(dut.tangent_y, (in.valid ? in.words[10] : ~in.words[10]) & UINT64_C(0xffff));
        put(dut.tangent_z, (in.valid ? in.words[11] : ~in.words[11]) & UINT64_C(0xffff));
        put(dut.binormal_x, (in.valid ? in.words[12] : ~in.words[12]) & UINT64_C(0xffff));
        put(dut.binormal_y, (in.valid ? in.words[13] : ~in.words[13]) & UINT64_C(0xffff));
        put(dut.binormal_z, (in.valid ? in.words[14] : ~in.words[14]) & UINT64_C(0xffff));
        put(dut.light_x, (in.valid ? in.words[15] : ~in.words[15]) & UINT64_C(0xfffffff));
        put(dut.light_y, (in.valid ? in.words[16] : ~in.words[16]) & UINT64_C(0xfffffff));
        put(dut.light_z, (in.valid ? in.words[17] : ~in.words[17]) & UINT64_C(0xfffffff));
        put(dut.vertex_x, (in.valid ? in.words[18] : ~in.words[18]) & UINT64_C(0xfffffff));
        put(dut.vertex_y, (in.valid ? in.words[19] : ~in.words[19]) & UINT64_C(0xfffffff));
        put(dut.vertex_z, (in.valid ? in.words[20] : ~in.words[20]) & UINT64_C(0xfffffff));
        put(dut.s0, (in.valid ? in.words[21] : ~in.words[21]) & UINT64_C(0x1ffffff));
        put(dut.t0, (in.valid ? in.words[22] : ~in.words[22]) & UINT64_C(0x1ffffff));
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
            const uint64_t got[] = {static_cast<uint64_t>(dut.ds), static_cast<uint64_t>(dut.dt), static_cast<uint64_t>(dut.s1), static_cast<uint64_t>(dut.t1), static_cast<uint64_t>(dut.degenerate)};
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
