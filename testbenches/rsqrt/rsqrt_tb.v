// rsqrt: 1/sqrt(a) by a table, a table with interpolation, or a table and a Newton step
// made by fixpath 0.1.0; the inverse square root unit of US 6,980,218, FIG. 8
//   input_bits=20 input_frac_bits=18 root_int_bits=9 root_scheme=linear root_addr_bits=9
//   root_frac_bits=18 rounding=half-up period_ps=5000 stages=auto rom=block
// latency 6 cycles, interval 1 cycle; tables read on the clock
// errors, absolute unless a scale is named, against the golden model of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst case:
//   r_relative: mean 1.23e-6, largest seen 4.83e-6 over the result, at a=269281
//   r_scaled: mean 9.98e-7, largest seen 4.76e-6 over the result, at least 1, at a=269281
//   r: mean 5.17e-5, largest seen 1.46e-3 (383.0 ulp) at a=1
//   degenerate: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at a=155754
// stated bound on each relative (relative to the result): 1.37e-5
// stated bound on each scaled (relative to the result, at least 1): 1.18e-5
// stated bound on each absolute: 5.08e-3
// stated bound on each flag: 0.00e0
//
// Self-checking testbench of rsqrt.
// Each line of rsqrt_vectors.txt holds the input words and then the
// expected output words, in hexadecimal. The first pass sends all vectors without stalls, one
// per cycle. The second pass sends the first 213 again with stalls and gaps,
// with a reset in mid-stream. Every bit of every output and the latency are compared.
// The last line says PASS or FAIL; a failure ends with a nonzero status.
// With +vcd the testbench writes rsqrt_tb.vcd.
module rsqrt_tb;
    localparam LATENCY = 6;
    localparam VECTORS = 213;
    localparam SHOWN = 10; // of the mismatches

    reg clk = 1'b0;
    reg rst = 1'b1;
    reg ce = 1'b1;
    reg valid_in = 1'b0;
    wire valid_out;
    // The prefix port_ keeps the ports' names apart from the names used here.
    reg [1:-18] port_a;
    wire [8:-18] port_r;
    wire port_degenerate;

    rsqrt dut (
        .clk(clk), .rst(rst), .ce(ce),
        .valid_in(valid_in), .valid_out(valid_out),
        .a(port_a),
        .r(port_r),
        .degenerate(port_degenerate)
    );

    // Expected outputs, shifted along with the pipeline; entry 0 belongs to the current inputs.
    reg [27:0] expected [0:LATENCY];
    reg valid [0:LATENCY];
    integer number [0:LATENCY];

    integer file, fields, sent, checked, mismatches, passed, i;
    reg more, stalls, reset_done, started;
    reg [31:0] lfsr; // decides on stalls and gaps
    reg [1:-18] next_a;
    reg [8:-18] next_r;
    reg next_degenerate;

    always #5 clk = ~clk;

    initial begin
        if ($test$plusargs("vcd")) begin
            $dumpfile("rsqrt_tb.vcd");
            $dumpvars(0, rsqrt_tb);
        end
        lfsr = 32'h2545f491;
        mismatches = 0;
        passed = 0;
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
            reset_done = 1'b0;
            file = $fopen("rsqrt_vectors.txt", "r");
            if (file == 0) begin
                $display("FAIL: rsqrt_vectors.txt can't be read");
                finish_failed;
            end
        end
    endtask

    task read_vector;
        begin
            fields = $fscanf(file, "%h %h %h ", next_a, next_r, next_degenerate);
            more = fields == 3;
            if (!more && fields > 0) begin
                mismatches = mismatches + 1;
                $display("mismatch: rsqrt_vectors.txt is cut short after vector %0d", sent);
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
            // Each word is checked once: in a cycle with ce, after which the pipeline advances.
            if (ce && valid[LATENCY]) begin
                if (port_r !== expected[LATENCY][27:1]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d r expected %h got %h",
                            number[LATENCY], expected[LATENCY][27:1], port_r);
                end
                if (port_degenerate !== expected[LATENCY][0:0]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d degenerate expected %h got %h",
                            number[LATENCY], expected[LATENCY][0:0], port_degenerate);
                end
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
        end
    endtask

    // Sets the inputs after this edge. They don't change while the pipeline is stalled.
    task drive;
        begin
            lfsr = {lfsr[30:0], lfsr[31] ^ lfsr[21] ^ lfsr[1] ^ lfsr[0]};
            rst <= 1'b0;
            ce <= !(stalls && lfsr[2:0] == 3'd0);
            if (ce) begin
                valid[0] = 1'b0;
                if (more && !(stalls && lfsr[5:3] == 3'd0)) begin
                    read_vector;
                    if (more) begin
                        valid[0] = 1'b1;
                        expected[0] = {next_r, next_degenerate};
                        number[0] = sent;
                        sent = sent + 1;
                        if (stalls && sent == 213) more = 1'b0;
                    end
                end
                valid_in <= valid[0];
                port_a <= valid[0] ? next_a : 20'bx;
            end
            // A reset in mid-stream takes effect despite the stall: words in flight are lost.
            if (stalls && !reset_done && sent == 213 / 2) begin
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
        drive;
        started = 1'b1;
        if (!more && checked == sent) begin
            $fclose(file);
            if (!stalls) begin
                passed = checked;
                stalls = 1'b1;
                open_vectors;
            end else finish;
        end
    end

    task finish;
        begin
            if (passed != VECTORS)
                $display("mismatch: rsqrt_vectors.txt holds %0d vectors and should hold %0d", passed, VECTORS);
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
