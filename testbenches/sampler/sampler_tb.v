// sampler: texels and fractions of texture coordinates, nearest or bilinear, wrapped or clamped
// made by fixpath 0.1.0; seed 000 (US 6,980,218), texture look-ups of the emboss; texel centres as in OpenGL
//   filter=bilinear address_s=wrap address_t=wrap int_bits=4 frac_bits=20 log2_width=9
//   log2_height=9 fraction_bits=8 period_ps=5000 stages=auto rom=block
// latency 1 cycle, interval 1 cycle; no tables
// absolute errors against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   i0: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at s=11969441 t=-12161653
//   i1: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at s=11969441 t=-12161653
//   a: mean 1.71e-3, largest seen 3.42e-3 (0.9 ulp) at s=-3629073 t=8031806
//   j0: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at s=11969441 t=-12161653
//   j1: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at s=11969441 t=-12161653
//   b: mean 1.71e-3, largest seen 3.42e-3 (0.9 ulp) at s=4664360 t=-2354817
// stated bound on each texel: 0.00e0
// stated bound on each fraction: 3.42e-3
//
// Self-checking testbench of sampler. It reads sampler_vectors.txt: per line the words of the
// inputs, then of the expected outputs, in hexadecimal. First all vectors go straight through,
// one a cycle; then, after a reset in mid-stream, the first 248 go again with stalls and
// gaps. Every bit of every output and the latency are compared. The last line says PASS or
// FAIL, and a failure ends with a status that isn't 0. With +vcd it writes sampler_tb.vcd.
module sampler_tb;
    localparam LATENCY = 1;
    localparam VECTORS = 248;
    localparam SHOWN = 10; // of the mismatches

    reg clk = 1'b0;
    reg rst = 1'b1;
    reg ce = 1'b1;
    reg valid_in = 1'b0;
    wire valid_out;
    // No port can have a name that stands here for something else.
    reg signed [4:-20] port_s;
    reg signed [4:-20] port_t;
    wire [8:0] port_i0;
    wire [8:0] port_i1;
    wire [-1:-8] port_a;
    wire [8:0] port_j0;
    wire [8:0] port_j1;
    wire [-1:-8] port_b;

    sampler dut (
        .clk(clk), .rst(rst), .ce(ce),
        .valid_in(valid_in), .valid_out(valid_out),
        .s(port_s),
        .t(port_t),
        .i0(port_i0),
        .i1(port_i1),
        .a(port_a),
        .j0(port_j0),
        .j1(port_j1),
        .b(port_b)
    );

    // What should come out, moving beside the pipeline; entry 0 belongs to what goes in.
    reg [51:0] expected [0:LATENCY];
    reg valid [0:LATENCY];
    integer number [0:LATENCY];

    integer file, fields, sent, checked, mismatches, passed, i;
    reg more, stalls, reset_done, started;
    reg [31:0] lfsr; // decides on stalls and gaps
    reg signed [4:-20] next_s;
    reg signed [4:-20] next_t;
    reg [8:0] next_i0;
    reg [8:0] next_i1;
    reg [-1:-8] next_a;
    reg [8:0] next_j0;
    reg [8:0] next_j1;
    reg [-1:-8] next_b;

    always #5 clk = ~clk;

    initial begin
        if ($test$plusargs("vcd")) begin
            $dumpfile("sampler_tb.vcd");
            $dumpvars(0, sampler_tb);
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
            file = $fopen("sampler_vectors.txt", "r");
            if (file == 0) begin
                $display("FAIL: sampler_vectors.txt can't be read");
                finish_failed;
            end
        end
    endtask

    task read_vector;
        begin
            fields = $fscanf(file, "%h %h %h %h %h %h %h %h ", next_s, next_t, next_i0, next_i1, next_a, next_j0, next_j1, next_b);
            more = fields == 8;
            if (!more && fields > 0) begin
                mismatches = mismatches + 1;
                $display("mismatch: sampler_vectors.txt is cut short after vector %0d", sent);
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
            // Each word counts once: in the cycle after which the pipeline moves on.
            if (ce && valid[LATENCY]) begin
                if (port_i0 !== expected[LATENCY][51:43]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d i0 expected %h got %h",
                            number[LATENCY], expected[LATENCY][51:43], port_i0);
                end
                if (port_i1 !== expected[LATENCY][42:34]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d i1 expected %h got %h",
                            number[LATENCY], expected[LATENCY][42:34], port_i1);
                end
                if (port_a !== expected[LATENCY][33:26]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d a expected %h got %h",
                            number[LATENCY], expected[LATENCY][33:26], port_a);
                end
                if (port_j0 !== expected[LATENCY][25:17]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d j0 expected %h got %h",
                            number[LATENCY], expected[LATENCY][25:17], port_j0);
                end
                if (port_j1 !== expected[LATENCY][16:8]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d j1 expected %h got %h",
                            number[LATENCY], expected[LATENCY][16:8], port_j1);
                end
                if (port_b !== expected[LATENCY][7:0]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d b expected %h got %h",
                            number[LATENCY], expected[LATENCY][7:0], port_b);
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

    // What goes in after this edge: words stay where the pipeline stood still.
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
                        expected[0] = {next_i0, next_i1, next_a, next_j0, next_j1, next_b};
                        number[0] = sent;
                        sent = sent + 1;
                        if (stalls && sent == 248) more = 1'b0;
                    end
                end
                valid_in <= valid[0];
                port_s <= valid[0] ? next_s : 25'bx;
                port_t <= valid[0] ? next_t : 25'bx;
            end
            // A reset in mid-stream, which a stall doesn't hold up: what is on its way is forgotten.
            if (stalls && !reset_done && sent == 248 / 2) begin
                rst <= 1'b1;
                ce <= 1'b0;
                reset_done = 1'b1;
            end
        end
    endtask

    always @(posedge clk) begin
        check;
        if (rst && stalls) begin
            // Forgotten, but for what hasn't gone in yet.
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
                $display("mismatch: sampler_vectors.txt holds %0d vectors and should hold %0d", passed, VECTORS);
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
