{% for line in header %}//{% if line %} {{ line }}{% endif %}
{% endfor -%}
//
// Verilator harness of {{ name }}.
// It feeds vectors from a file, or from standard input if no file is given, with random stalls
// and gaps{% if not state %} and a reset in mid-stream{% endif %}, and compares every bit of every output and the latency.
// The last line says PASS or FAIL; the status is 0 or 1.
#include "V{{ top }}.h"
#include "verilated.h"
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <vector>

static constexpr int kInputs = {{ inputs | length }};
static constexpr int kOutputs = {{ outputs | length }};
static constexpr int kFields = kInputs + kOutputs;
static constexpr int kLatency = {{ latency }};
{%- if interval > 1 %}
static constexpr int kInterval = {{ interval }};
{%- endif %}
static constexpr uint64_t kShown = 10;  // of the mismatches
static const char* const kNames[] = { {%- for port in outputs %}"{{ port.name }}"{{ ", " if not loop.last }}{% endfor -%} };

// Hexadecimal words, {{ (inputs | length) + (outputs | length) }} per line.
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
    V{{ top }} dut{&context};
    Vectors vectors(file);

    // Expected outputs, shifted along with the pipeline; the newest entry is at `head`.
    std::vector<Entry> pipe(kLatency + 1);
    int head = 0;
    // Words lost in the reset; they are sent again.
    std::deque<Entry> again;
{%- if interval > 1 %}
    int phase = 0;  // as the module should count it
{%- endif %}
    uint64_t sent = 0, checked = 0, mismatches = 0;
    uint64_t random = 0x9e3779b97f4a7c15u;
    bool more = true, cut = false, reset_done = {{ "true;  // it would forget words of earlier samples" if state else "kLatency == 0;" }}
{%- if latency > 0 %}

    dut.rst = 1;
    dut.ce = 0;
    dut.valid_in = 0;
{%- if resets > 1 %}
    // The reset lasts until the memories are written.
    for (int cycle = 0; cycle < {{ resets }}; ++cycle) {
        dut.clk = 0;
        dut.eval();
        dut.clk = 1;
        dut.eval();
    }
{%- else %}
    dut.clk = 0;
    dut.eval();
    dut.clk = 1;
    dut.eval();
{%- endif %}
    dut.rst = 0;
{%- endif %}

    while (checked < sent || more) {
        random ^= random << 13;
        random ^= random >> 7;
        random ^= random << 17;
        // Stalls and gaps don't depend on the words.
        // The reset comes while the pipeline is full, during a stall, and takes effect despite it.
        const bool reset = !reset_done && sent{% if interval > 1 %} * kInterval{% endif %} > kLatency{% if interval > 1 %} && phase == kInterval / 2{% endif %};
        reset_done = reset_done || reset;
        const bool ce = kLatency == 0 || (!reset && (random & 15) != 0);
        const bool gap = {% if interval > 1 %}phase != 0 || {% endif %}(random >> 4 & 15) == 0;
        Entry& in = pipe[head];
        if (!in.valid && !gap && !again.empty()) {
            in = again.front();
            again.pop_front();
        } else if (!in.valid && !gap && more) {
            in.valid = more = vectors.read(in.words, cut);
            if (in.valid) in.number = sent++;
        }
        dut.valid_in = in.valid{% if interval > 1 %} || (phase != 0 && (random >> 8 & 1) != 0){% endif %};
{%- for port in inputs %}
        put(dut.{{ port.name }}, (in.valid ? in.words[{{ loop.index0 }}] : ~in.words[{{ loop.index0 }}]) & UINT64_C({{ port.mask }}));
{%- endfor %}
{%- if latency > 0 %}
        dut.ce = ce;
        dut.rst = reset;
        dut.clk = 0;
{%- endif %}
        dut.eval();
{%- if interval > 1 %}
        if (dut.ready != (phase == 0) && ++mismatches <= kShown) {
            printf("mismatch: vector %" PRIu64 " ready expected %d got %d\n", sent, phase == 0, dut.ready);
        }
{%- endif %}

        const Entry& out = pipe[(head + kLatency) % (kLatency + 1)];
        if (dut.valid_out != out.valid && ++mismatches <= kShown) {
            printf("mismatch: vector %" PRIu64 " valid_out expected %d got %d\n", out.valid ? out.number : sent,
                   out.valid, dut.valid_out);
        }
        if (ce && out.valid) {
            const uint64_t got[] = { {%- for port in outputs %}static_cast<uint64_t>(dut.{{ port.name }}){{ ", " if not loop.last }}{% endfor -%} };
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
{%- if interval > 1 %}
            phase = (phase + 1) % kInterval;
{%- endif %}
        }
{%- if interval > 1 %}
        if (reset) phase = 0;
{%- endif %}
        for (int stage = kLatency; reset && stage > 0; --stage) {
            Entry& forgotten = pipe[(head + stage) % (kLatency + 1)];
            if (forgotten.valid) again.push_back(forgotten);
            forgotten.valid = false;
        }
{%- if latency > 0 %}
        dut.clk = 1;
        dut.eval();
{%- endif %}
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
