{% for line in header %}//{% if line %} {{ line }}{% endif %}
{% endfor -%}
//
// Self-checking testbench of {{ name }}.
// Each line of {{ vectors }} holds the input words and then the
// expected output words, in hexadecimal. The first pass sends all vectors without stalls, one
// {% if interval > 1 %}every {{ interval }} cycles when the module is ready, with words that it must ignore in between.
// The{% else %}per cycle. The{% endif %} second pass sends the first {{ again }} again with stalls and gaps,
// {% if state %}starting with a reset{% else %}with a reset in mid-stream{% endif %}. Every bit of every output and the latency are compared.
// The last line says PASS or FAIL; a failure ends with a nonzero status.
// With +vcd the testbench writes {{ name }}_tb.vcd.
module {{ name }}_tb;
    localparam LATENCY = {{ latency }};
{%- if interval > 1 %}
    localparam INTERVAL = {{ interval }};
{%- endif %}
    localparam VECTORS = {{ count }};
    localparam SHOWN = 10; // of the mismatches

    reg clk = 1'b0;
    reg rst = 1'b1;
    reg ce = 1'b1;
    reg valid_in = 1'b0;
    wire valid_out;
{%- if interval > 1 %}
    wire ready;
{%- endif %}
    // The prefix port_ keeps the ports' names apart from the names used here.
{%- for port in inputs %}
    reg {{ port.shape }}port_{{ port.name }};
{%- endfor %}
{%- for port in outputs %}
    wire {{ port.shape }}port_{{ port.name }};
{%- endfor %}

    {{ top }} dut (
{%- if latency > 0 %}
        .clk(clk), .rst(rst), .ce(ce),
{%- endif %}
        .valid_in(valid_in), .valid_out(valid_out)
{%- if interval > 1 %},
        .ready(ready)
{%- endif %}
{%- for port in inputs + outputs -%}
        ,
        .{{ port.name }}(port_{{ port.name }})
{%- endfor %}
    );

    // Expected outputs, shifted along with the pipeline; entry 0 belongs to the current inputs.
    reg [{{ output_bits - 1 }}:0] expected [0:LATENCY];
    reg valid [0:LATENCY];
    integer number [0:LATENCY];

    integer file, fields, sent, checked, mismatches, passed, i;
    reg more, stalls, reset_done, started;
{%- if interval > 1 %}
    integer phase; // as the module should count it
{%- endif %}
{%- if resets > 1 %}
    integer resets; // cycles under reset that are left: memories are written
{%- endif %}
    reg [31:0] lfsr; // decides on stalls and gaps
{%- for port in inputs + outputs %}
    reg {{ port.shape }}next_{{ port.name }};
{%- endfor %}

    always #5 clk = ~clk;

    initial begin
        if ($test$plusargs("vcd")) begin
            $dumpfile("{{ name }}_tb.vcd");
            $dumpvars(0, {{ name }}_tb);
        end
        lfsr = 32'h2545f491;
        mismatches = 0;
        passed = 0;
{%- if interval > 1 %}
        phase = 0;
{%- endif %}
{%- if resets > 1 %}
        resets = {{ resets }};
{%- endif %}
        stalls = 1'b0;
        started = 1'b0; // nothing is known before the first edge under reset
        for (i = 0; i <= LATENCY; i = i + 1) valid[i] = 1'b0;
        open_vectors;
    end

    task finish_failed;
        begin
`ifdef __ICARUS__
            $finish_and_return(1);
`else
            $fatal(0);
`endif
        end
    endtask

    task open_vectors;
        begin
            sent = 0;
            checked = 0;
            more = 1'b1;
            reset_done = 1'b{{ 1 if state else 0 }};{{ " // it would forget words of earlier samples" if state }}
            file = $fopen("{{ vectors }}", "r");
            if (file == 0) begin
                $display("FAIL: {{ vectors }} can't be read");
                finish_failed;
            end
        end
    endtask

    task read_vector;
        begin
            fields = $fscanf(file, "{% for port in inputs + outputs %}%h {% endfor %}"
{%- for port in inputs + outputs %}, next_{{ port.name }}{% endfor %});
            more = fields == {{ (inputs | length) + (outputs | length) }};
            if (!more && fields > 0) begin
                mismatches = mismatches + 1;
                $display("mismatch: {{ vectors }} is cut short after vector %0d", sent);
            end
        end
    endtask

    task check;
        begin
            if (started && valid_out !== valid[LATENCY]) begin
                mismatches = mismatches + 1;
                if (mismatches <= SHOWN)
                    $display("mismatch: vector %0d valid_out expected %b got %b", checked, valid[LATENCY], valid_out);
            end
{%- if interval > 1 %}
            if (started && ready !== (phase == 0)) begin
                mismatches = mismatches + 1;
                if (mismatches <= SHOWN)
                    $display("mismatch: vector %0d ready expected %b got %b", sent, phase == 0, ready);
            end
{%- endif %}
            // Each word is checked once: in a cycle with ce, after which the pipeline advances.
            if (ce && valid[LATENCY]) begin
{%- for port in outputs %}
                if (port_{{ port.name }} !== expected[LATENCY]{{ port.slice }}) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d {{ port.name }} expected %h got %h",
                            number[LATENCY], expected[LATENCY]{{ port.slice }}, port_{{ port.name }});
                end
{%- endfor %}
                checked = checked + 1;
            end
        end
    endtask

    task move_on;
        begin
            for (i = LATENCY; i > 0; i = i - 1) begin
                if (rst) valid[i] = 1'b0;
                else if (ce) valid[i] = valid[i - 1];
                if (ce) expected[i] = expected[i - 1];
                if (ce) number[i] = number[i - 1];
            end
{%- if interval > 1 %}
            if (rst) phase = 0;
            else if (ce) phase = (phase + 1) % INTERVAL;
{%- endif %}
        end
    endtask

    // Sets the inputs after this edge. They don't change while the pipeline is stalled.
    task drive;
        begin
            lfsr = {lfsr[30:0], lfsr[31] ^ lfsr[21] ^ lfsr[1] ^ lfsr[0]};
            rst <= 1'b0;
            ce <= !(stalls && lfsr[2:0] == 3'd0);
            if (ce{% if interval > 1 %} || !valid[0]{% endif %}) begin
                valid[0] = 1'b0;
                if ({% if interval > 1 %}phase == 0 && {% endif %}more && !(stalls && lfsr[5:3] == 3'd0)) begin
                    read_vector;
                    if (more) begin
                        valid[0] = 1'b1;
                        expected[0] = { {%- for port in outputs %}next_{{ port.name }}{{ ", " if not loop.last }}{% endfor -%} };
                        number[0] = sent;
                        sent = sent + 1;
                        if (stalls && sent == {{ again }}) more = 1'b0;
                    end
                end
                valid_in <= valid[0]{% if interval > 1 %} || (phase != 0 && lfsr[6]){% endif %};
{%- for port in inputs %}
                port_{{ port.name }} <= valid[0] ? next_{{ port.name }} : {{ port.bits }}'bx;
{%- endfor %}
            end
            // A reset in mid-stream takes effect despite the stall: words in flight are lost.
            if (stalls && !reset_done && sent == {{ again }} / 2{% if interval > 1 %} && phase == INTERVAL / 2{% endif %}) begin
                rst <= 1'b1;
                ce <= 1'b0;
                reset_done = 1'b1;
            end
        end
    endtask

    always @(posedge clk) begin
        check;
        if (rst && stalls) begin
            // Words in flight are lost. The word that hasn't entered yet isn't.
            for (i = 1; i <= LATENCY; i = i + 1) if (valid[i]) checked = checked + 1;
        end
        move_on;
{%- if resets > 1 %}
        if (resets > 1) resets = resets - 1;
        else drive;
{%- else %}
        drive;
{%- endif %}
        started = 1'b1;
        if (!more && checked == sent) begin
            $fclose(file);
            if (!stalls) begin
                passed = checked;
                stalls = 1'b1;
{%- if state %}
                rst <= 1'b1;
{%- endif %}
                open_vectors;
            end else finish;
        end
    end

    task finish;
        begin
            if (passed != VECTORS)
                $display("mismatch: {{ vectors }} holds %0d vectors and should hold %0d", passed, VECTORS);
            if (mismatches == 0 && passed == VECTORS) begin
                $display("PASS %0d vectors", passed);
                $finish(0);
            end else begin
                $display("FAIL %0d mismatches in %0d vectors", mismatches, passed);
                finish_failed;
            end
        end
    endtask
endmodule
