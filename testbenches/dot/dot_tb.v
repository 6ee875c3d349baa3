// dot: dot product of three: exact products and sums, one rounding
// made by fixpath 0.1.0; the vector dot units of seed 000 (US 6,980,218, FIG. 8), in formats of any width
//   v_bits=16 v_frac_bits=14 w_bits=16 w_frac_bits=14 out_bits=24 out_frac_bits=18
//   overflow=saturate rounding=half-up period_ps=5000 stages=auto rom=block
// latency 3 cycles, interval 1 cycle; no tables
// absolute errors against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   dot_product: mean 9.56e-7, largest seen 1.91e-6 (0.5 ulp) at v_x=-62 v_y=-9 v_z=-2277 w_x=-2863 w_y=-7 w_z=13
// stated bound on each result: 1.91e-6
//
// Self-checking testbench of dot. It reads dot_vectors.txt: per line the words of the
// inputs, then of the expected outputs, in hexadecimal. First all vectors go straight through,
// one a cycle; then, after a reset in mid-stream, the first 225 go again with stalls and
// gaps. Every bit of every output and the latency are compared. The last line says PASS or
// FAIL, and a failure ends with a status that isn't 0. With +vcd it writes dot_tb.vcd.
module dot_tb;
    localparam LATENCY = 3;
    localparam VECTORS = 225;
    localparam SHOWN = 10; // of the mismatches

    reg clk = 1'b0;
    reg rst = 1'b1;
    reg ce = 1'b1;
    reg valid_in = 1'b0;
    wire valid_out;
    // No port can have a name that stands here for something else.
    reg signed [1:-14] port_v_x;
    reg signed [1:-14] port_v_y;
    reg signed [1:-14] port_v_z;
    reg signed [1:-14] port_w_x;
    reg signed [1:-14] port_w_y;
    reg signed [1:-14] port_w_z;
    wire signed [5:-18] port_dot_product;

    dot dut (
        .clk(clk), .rst(rst), .ce(ce),
        .valid_in(valid_in), .valid_out(valid_out),
        .v_x(port_v_x),
        .v_y(port_v_y),
        .v_z(port_v_z),
        .w_x(port_w_x),
        .w_y(port_w_y),
        .w_z(port_w_z),
        .dot_product(port_dot_product)
    );

    // What should come out, moving beside the pipeline; entry 0 belongs to what goes in.
    reg [23:0] expected [0:LATENCY];
    reg valid [0:LATENCY];
    integer number [0:LATENCY];

    integer file, fields, sent, checked, mismatches, passed, i;
    reg more, stalls, reset_done, started;
    reg [31:0] lfsr; // decides on stalls and gaps
    reg signed [1:-14] next_v_x;
    reg signed [1:-14] next_v_y;
    reg signed [1:-14] next_v_z;
    reg signed [1:-14] next_w_x;
    reg signed [1:-14] next_w_y;
    reg signed [1:-14] next_w_z;
    reg signed [5:-18] next_dot_product;

    always #5 clk = ~clk;

    initial begin
        if ($test$plusargs("vcd")) begin
            $dumpfile("dot_tb.vcd");
            $dumpvars(0, dot_tb);
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
            file = $fopen("dot_vectors.txt", "r");
            if (file == 0) begin
                $display("FAIL: dot_vectors.txt can't be read");
                finish_failed;
            end
        end
    endtask

    task read_vector;
        begin
            fields = $fscanf(file, "%h %h %h %h %h %h %h ", next_v_x, next_v_y, next_v_z, next_w_x, next_w_y, next_w_z, next_dot_product);
            more = fields == 7;
            if (!more && fields > 0) begin
                mismatches = mismatches + 1;
                $display("mismatch: dot_vectors.txt is cut short after vector %0d", sent);
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
                if (port_dot_product !== expected[LATENCY][23:0]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d dot_product expected %h got %h",
                            number[LATENCY], expected[LATENCY][23:0], port_dot_product);
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
                        expected[0] = {next_dot_product};
                        number[0] = sent;
                        sent = sent + 1;
                        if (stalls && sent == 225) more = 1'b0;
                    end
                end
                valid_in <= valid[0];
                port_v_x <= valid[0] ? next_v_x : 16'bx;
                port_v_y <= valid[0] ? next_v_y : 16'bx;
                port_v_z <= valid[0] ? next_v_z : 16'bx;
                port_w_x <= valid[0] ? next_w_x : 16'bx;
                port_w_y <= valid[0] ? next_w_y : 16'bx;
                port_w_z <= valid[0] ? next_w_z : 16'bx;
            end
            // A reset in mid-stream, which a stall doesn't hold up: what is on its way is forgotten.
            if (stalls && !reset_done && sent == 225 / 2) begin
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
                $display("mismatch: dot_vectors.txt holds %0d vectors and should hold %0d", passed, VECTORS);
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
