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
// Self-checking testbench of combine. It reads combine_vectors.txt: per line the words of the
// inputs, then of the expected outputs, in hexadecimal. First all vectors go straight through,
// one a cycle; then, after a reset in mid-stream, the first 240 go again with stalls and
// gaps. Every bit of every output and the latency are compared. The last line says PASS or
// FAIL, and a failure ends with a status that isn't 0. With +vcd it writes combine_tb.vcd.
module combine_tb;
    localparam LATENCY = 4;
    localparam VECTORS = 240;
    localparam SHOWN = 10; // of the mismatches

    reg clk = 1'b0;
    reg rst = 1'b1;
    reg ce = 1'b1;
    reg valid_in = 1'b0;
    wire valid_out;
    // No port can have a name that stands here for something else.
    reg [7:0] port_h_00;
    reg [7:0] port_h_10;
    reg [7:0] port_h_01;
    reg [7:0] port_h_11;
    reg [-1:-8] port_h_a;
    reg [-1:-8] port_h_b;
    reg [7:0] port_d0_00;
    reg [7:0] port_d0_10;
    reg [7:0] port_d0_01;
    reg [7:0] port_d0_11;
    reg [-1:-8] port_d0_a;
    reg [-1:-8] port_d0_b;
    reg [7:0] port_r;
    reg [7:0] port_g;
    reg [7:0] port_b;
    wire [7:0] port_out_r;
    wire [7:0] port_out_g;
    wire [7:0] port_out_b;

    combine dut (
        .clk(clk), .rst(rst), .ce(ce),
        .valid_in(valid_in), .valid_out(valid_out),
        .h_00(port_h_00),
        .h_10(port_h_10),
        .h_01(port_h_01),
        .h_11(port_h_11),
        .h_a(port_h_a),
        .h_b(port_h_b),
        .d0_00(port_d0_00),
        .d0_10(port_d0_10),
        .d0_01(port_d0_01),
        .d0_11(port_d0_11),
        .d0_a(port_d0_a),
        .d0_b(port_d0_b),
        .r(port_r),
        .g(port_g),
        .b(port_b),
        .out_r(port_out_r),
        .out_g(port_out_g),
        .out_b(port_out_b)
    );

    // What should come out, moving beside the pipeline; entry 0 belongs to what goes in.
    reg [23:0] expected [0:LATENCY];
    reg valid [0:LATENCY];
    integer number [0:LATENCY];

    integer file, fields, sent, checked, mismatches, passed, i;
    reg more, stalls, reset_done, started;
    reg [31:0] lfsr; // decides on stalls and gaps
    reg [7:0] next_h_00;
    reg [7:0] next_h_10;
    reg [7:0] next_h_01;
    reg [7:0] next_h_11;
    reg [-1:-8] next_h_a;
    reg [-1:-8] next_h_b;
    reg [7:0] next_d0_00;
    reg [7:0] next_d0_10;
    reg [7:0] next_d0_01;
    reg [7:0] next_d0_11;
    reg [-1:-8] next_d0_a;
    reg [-1:-8] next_d0_b;
    reg [7:0] next_r;
    reg [7:0] next_g;
    reg [7:0] next_b;
    reg [7:0] next_out_r;
    reg [7:0] next_out_g;
    reg [7:0] next_out_b;

    always #5 clk = ~clk;

    initial begin
        if ($test$plusargs("vcd")) begin
            $dumpfile("combine_tb.vcd");
            $dumpvars(0, combine_tb);
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
            file = $fopen("combine_vectors.txt", "r");
            if (file == 0) begin
                $display("FAIL: combine_vectors.txt can't be read");
                finish_failed;
            end
        end
    endtask

    task read_vector;
        begin
            fields = $fscanf(file, "%h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h ", next_h_00, next_h_10, next_h_01, next_h_11, next_h_a, next_h_b, next_d0_00, next_d0_10, next_d0_01, next_d0_11, next_d0_a, next_d0_b, next_r, next_g, next_b, next_out_r, next_out_g, next_out_b);
            more = fields == 18;
            if (!more && fields > 0) begin
                mismatches = mismatches + 1;
                $display("mismatch: combine_vectors.txt is cut short after vector %0d", sent);
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
                if (port_out_r !== expected[LATENCY][23:16]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d out_r expected %h got %h",
                            number[LATENCY], expected[LATENCY][23:16], port_out_r);
                end
                if (port_out_g !== expected[LATENCY][15:8]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d out_g expected %h got %h",
                            number[LATENCY], expected[LATENCY][15:8], port_out_g);
                end
                if (port_out_b !== expected[LATENCY][7:0]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d out_b expected %h got %h",
                            number[LATENCY], expected[LATENCY][7:0], port_out_b);
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
                        expected[0] = {next_out_r, next_out_g, next_out_b};
                        number[0] = sent;
                        sent = sent + 1;
                        if (stalls && sent == 240) more = 1'b0;
                    end
                end
                valid_in <= valid[0];
                port_h_00 <= valid[0] ? next_h_00 : 8'bx;
                port_h_10 <= valid[0] ? next_h_10 : 8'bx;
                port_h_01 <= valid[0] ? next_h_01 : 8'bx;
                port_h_11 <= valid[0] ? next_h_11 : 8'bx;
                port_h_a <= valid[0] ? next_h_a : 8'bx;
                port_h_b <= valid[0] ? next_h_b : 8'bx;
                port_d0_00 <= valid[0] ? next_d0_00 : 8'bx;
                port_d0_10 <= valid[0] ? next_d0_10 : 8'bx;
                port_d0_01 <= valid[0] ? next_d0_01 : 8'bx;
                port_d0_11 <= valid[0] ? next_d0_11 : 8'bx;
                port_d0_a <= valid[0] ? next_d0_a : 8'bx;
                port_d0_b <= valid[0] ? next_d0_b : 8'bx;
                port_r <= valid[0] ? next_r : 8'bx;
                port_g <= valid[0] ? next_g : 8'bx;
                port_b <= valid[0] ? next_b : 8'bx;
            end
            // A reset in mid-stream, which a stall doesn't hold up: what is on its way is forgotten.
            if (stalls && !reset_done && sent == 240 / 2) begin
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
                $display("mismatch: combine_vectors.txt holds %0d vectors and should hold %0d", passed, VECTORS);
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
