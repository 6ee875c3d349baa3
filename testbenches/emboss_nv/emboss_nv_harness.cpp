// emboss: texture coordinates displaced by the direction of a light, for embossing
// made by fixpath 0.1.0; seeds 000 and 003 (US 6,980,218; US 7,307,640), seed 002 (GL_NV_texgen_emboss)
//   setting=nv frame=auto normalise_basis=auto s_vector=auto l_sign=light-vertex t_sign=auto
//   scale_q=auto constants=auto ks=1 kt=1 input20=off component_bits=16 matrix_bits=16
//   matrix_int_bits=2 position_bits=28 position_frac_bits=15 guard_bits=4 norm_bits=18
//   dot_frac_bits=20 root_scheme=linear root_addr_bits=9 root_frac_bits=18 constant_int_bits=auto
//   constant_frac_bits=auto texture_int_bits=6 texture_frac_bits=18 overflow=saturate
//   rounding=half-up texture_size=256 light=0 source=0 destination=1 period_ps=5000 stages=auto
//   rom=block
// latency 25 cycles, interval 1 cycle; tables read on the clock
// errors, absolute where nothing else is said, against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   ds_texels: mean 8.34e-4 texel, largest seen 6.81e-3 texel at normal_x=-403 normal_y=4343 normal_z=17658 ct_x=-16730 ct_y=-4206 ct_z=-10791 light_x=-19512504 light_y=-18114054 light_z=8315440 vertex_x=-16955403 vertex_y=-18333786 vertex_z=3893611 s0=2208087 t0=-3181104 q0=504736 r0=-29596
//   ds_relative: mean 2.65e-6, largest seen 1.57e-5 over the vector's length times its factor, each 1/4 where it is less, at normal_x=16750 normal_y=-6938 normal_z=100 ct_x=370 ct_y=-1703 ct_z=18454 light_x=-21858093 light_y=11862104 light_z=22208289 vertex_x=-20247618 vertex_y=12204548 vertex_z=17798660 s0=2324101 t0=-917458 q0=289204 r0=140514
//   ds: mean 3.26e-6, largest seen 2.66e-5 (7.0 ulp) at normal_x=-403 normal_y=4343 normal_z=17658 ct_x=-16730 ct_y=-4206 ct_z=-10791 light_x=-19512504 light_y=-18114054 light_z=8315440 vertex_x=-16955403 vertex_y=-18333786 vertex_z=3893611 s0=2208087 t0=-3181104 q0=504736 r0=-29596
//   dt_texels: mean 7.78e-4 texel, largest seen 6.34e-3 texel at normal_x=7206 normal_y=-1587 normal_z=-17062 ct_x=-15241 ct_y=-684 ct_z=-1332 light_x=13815813 light_y=18380882 light_z=25053412 vertex_x=13614035 vertex_y=18660875 vertex_z=25060581 s0=-3345646 t0=-547138 q0=402065 r0=5114
//   dt_relative: mean 2.48e-6, largest seen 1.69e-5 over the vector's length times its factor, each 1/4 where it is less, at normal_x=539 normal_y=10101 normal_z=11796 ct_x=-4134 ct_y=-13685 ct_z=9001 light_x=-16348031 light_y=19544902 light_z=11919376 vertex_x=-16890033 vertex_y=19483858 vertex_z=11791741 s0=601665 t0=-1430898 q0=258948 r0=-148469
//   dt: mean 3.04e-6, largest seen 2.48e-5 (6.5 ulp) at normal_x=7206 normal_y=-1587 normal_z=-17062 ct_x=-15241 ct_y=-684 ct_z=-1332 light_x=13815813 light_y=18380882 light_z=25053412 vertex_x=13614035 vertex_y=18660875 vertex_z=25060581 s0=-3345646 t0=-547138 q0=402065 r0=5114
//   s1: mean 3.26e-6, largest seen 2.66e-5 (7.0 ulp) at normal_x=-403 normal_y=4343 normal_z=17658 ct_x=-16730 ct_y=-4206 ct_z=-10791 light_x=-19512504 light_y=-18114054 light_z=8315440 vertex_x=-16955403 vertex_y=-18333786 vertex_z=3893611 s0=2208087 t0=-3181104 q0=504736 r0=-29596
//   t1: mean 3.04e-6, largest seen 2.48e-5 (6.5 ulp) at normal_x=7206 normal_y=-1587 normal_z=-17062 ct_x=-15241 ct_y=-684 ct_z=-1332 light_x=13815813 light_y=18380882 light_z=25053412 vertex_x=13614035 vertex_y=18660875 vertex_z=25060581 s0=-3345646 t0=-547138 q0=402065 r0=5114
//   degenerate: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at normal_x=-2531 normal_y=7271 normal_z=-13448 ct_x=-2894 ct_y=-19246 ct_z=1152 light_x=22420812 light_y=22017016 light_z=19624152 vertex_x=22724046 vertex_y=26548838 vertex_z=18617859 s0=2750663 t0=-1626897 q0=492838 r0=-122705
//   q1: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at normal_x=-2531 normal_y=7271 normal_z=-13448 ct_x=-2894 ct_y=-19246 ct_z=1152 light_x=22420812 light_y=22017016 light_z=19624152 vertex_x=22724046 vertex_y=26548838 vertex_z=18617859 s0=2750663 t0=-1626897 q0=492838 r0=-122705
//   r1: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at normal_x=-2531 normal_y=7271 normal_z=-13448 ct_x=-2894 ct_y=-19246 ct_z=1152 light_x=22420812 light_y=22017016 light_z=19624152 vertex_x=22724046 vertex_y=26548838 vertex_z=18617859 s0=2750663 t0=-1626897 q0=492838 r0=-122705
// stated bound on each relative displacement (over the vector's length times its factor, each 1/4 where it is less): 1.09e-4
// stated bound on each displacement: 1.32e-2
// stated bound on each displacement in texels: 3.38e0
// stated bound on each coordinate: 1.32e-2
// stated bound on each flag and what is passed: 0.00e0
//
// Verilator's harness of emboss_nv: feeds vectors from a file, or from the standard input if
// there is none, with stalls and gaps now and then and a reset in mid-stream, and compares every
// bit of every output and the latency. The last line says PASS or FAIL; the status is 0 or 1.
#include "Vemboss_nv.h"
#include "verilated.h"
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <vector>

static constexpr int kInputs = 16;
static constexpr int kOutputs = 7;
static constexpr int kFields = kInputs + kOutputs;
static constexpr int kLatency = 25;
static constexpr uint64_t kShown = 10;  // of the mismatches
static const char* const kNames[] = {"ds", "dt", "s1", "t1", "degenerate", "q1", "r1"};

// Hexadecimal words, 23 a line.
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
    Vemboss_nv dut{&context};
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
        put(dut.light_x, (in.valid ? in.words[6] : ~in.words[6]) & UINT64_C(0xfffffff));
        put(dut.light_y, (in.valid ? in.words[7] : ~in.words[7]) & UINT64_C(0xfffffff));
        put(dut.light_z, (in.valid ? in.words[8] : ~in.words[8]) & UINT64_C(0xfffffff));
        put(dut.vertex_x, (in.valid ? in.words[9] : ~in.words[9]) & UINT64_C(0xfffffff));
        put(dut.vertex_y, (in.valid ? in.words[10] : ~in.words[10]) & UINT64_C(0xfffffff));
        put(dut.vertex_z, (in.valid ? in.words[11] : ~in.words[11]) & UINT64_C(0xfffffff));
        put(dut.s0, (in.valid ? in.words[12] : ~in.words[12]) & UINT64_C(0x1ffffff));
        put(dut.t0, (in.valid ? in.words[13] : ~in.words[13]) & UINT64_C(0x1ffffff));
        put(dut.q0, (in.valid ? in.words[14] : ~in.words[14]) & UINT64_C(0x1ffffff));
        put(dut.r0, (in.valid ? in.words[15] : ~in.words[15]) & UINT64_C(0x1ffffff));
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
            const uint64_t got[] = {static_cast<uint64_t>(dut.ds), static_cast<uint64_t>(dut.dt), static_cast<uint64_t>(dut.s1), static_cast<uint64_t>(dut.t1), static_cast<uint64_t>(dut.degenerate), static_cast<uint64_t>(dut.q1), static_cast<uint64_t>(dut.r1)};
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
