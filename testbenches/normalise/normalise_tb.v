// normalise: block normalisation: three words shifted by the leading zeros of the largest
// made by fixpath 0.1.0; the light vector of seed 000 (US 6,980,218) in fixed point: a displacement doesn't depend on its length
//   v_bits=16 v_frac_bits=8 norm_bits=18 rounding=half-up period_ps=5000 stages=auto rom=block
// latency 2 cycles, interval 1 cycle; no tables
// absolute errors against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   x: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at v_x=-7127 v_y=-10 v_z=-68
//   y: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at v_x=-7127 v_y=-10 v_z=-68
//   z: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at v_x=-7127 v_y=-10 v_z=-68
//   places: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at v_x=-7127 v_y=-10 v_z=-68
//   degenerate: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at v_x=-7127 v_y=-10 v_z=-68
// stated bound on each component: 7.63e-6
// stated bound on each count and flag: 0.00e0
//
// Self-checking testbench of normalise. It reads normalise_vectors.txt: per line the words of the
// inputs, then of the expected outputs, in hexadecimal. First all vectors go straight through,
// one a cycle; then, after a reset in mid-stream, the first 225 go again with stalls and
// gaps. Every bit of every output and the latency are compared. The last line says PASS or
// FAIL, and a failure ends with a status that isn't 0. With +vcd it writes normalise_tb.vcd.
module normalise_tb;
    localparam LATENCY = 2;
    localparam VECTORS = 225;
    localparam SHOWN = 10; // of the mismatches

    reg clk = 1'b0;
    reg rst = 1'b1;
    reg ce = 1'b1;
    reg valid_in = 1'b0;
    wire valid_out;
    // No port can have a name that stands here for something else.
    reg signed [7:-8] port_v_x;
    reg signed [7:-8] port_v_y;
    reg signed [7:-8] port_v_z;
    wire signed [0:-17] port_x;
    wire signed [0:-17] port_y;
    wire signed [0:-17] port_z;
    wire [3:0] port_places;
    wire port_degenerate;

    normalise dut (
        .clk(clk), .rst(rst), .ce(ce),
        .valid_in(valid_in), .valid_out(valid_out),
        .v_x(port_v_x),
        .v_y(port_v_y),
        .v_z(port_v_z),
        .x(port_x),
        .y(port_y),
        .z(port_z),
        .places(port_places),
        .degenerate(port_degenerate)
    );

    // What should come out, moving beside the pipeline; entry 0 belongs to what goes in.
    reg [58:0] expected [0:LATENCY];
    reg valid [0:LATENCY];
    integer number [0:LATENCY];

    integer file, fields, sent, checked, mismatches, passed, i;
    reg more, stalls, reset_done, started;
    reg [31:0] lfsr; // decides on stalls and gaps
    reg signed [7:-8] next_v_x;
    reg signed [7:-8] next_v_y;
    reg signed [7:-8] next_v_z;
    reg signed [0:-17] next_x;
    reg signed [0:-17] next_y;
    reg signed [0:-17] next_z;
    reg [3:0] next_places;
    reg next_degenerate;

    always #5 clk = ~clk;

    initial begin
        if ($test$plusargs("vcd")) begin
            $dumpfile("normalise_tb.vcd");
            $dumpvars(0, normalise_tb);
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
            file = $fopen("normalise_vectors.txt", "r");
            if (file == 0) begin
                $display("FAIL: normalise_vectors.txt can't be read");
                finish_failed;
            end
        end
    endtask

    task read_vector;
        begin
            fields = $fscanf(file, "%h %h %h %h %h %h %h %h ", next_v_x, next_v_y, next_v_z, next_x, next_y, next_z, next_places, next_degenerate);
            more = fields == 8;
            if (!more && fields > 0) begin
                mismatches = mismatches + 1;
                $display("mismatch: normalise_vectors.txt is cut short after vector %0d", sent);
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
                if (port_x !== expected[LATENCY][58:41]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d x expected %h got %h",
                            number[LATENCY], expected[LATENCY][58:41], port_x);
                end
                if (port_y !== expected[LATENCY][40:23]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d y expected %h got %h",
                            number[LATENCY], expected[LATENCY][40:23], port_y);
                end
                if (port_z !== expected[LATENCY][22:5]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d z expected %h got %h",
                            number[LATENCY], expected[LATENCY][22:5], port_z);
                end
                if (port_places !== expected[LATENCY][4:1]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d places expected %h got %h",
                            number[LATENCY], expected[LATENCY][4:1], port_places);
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
                        expected[0] = {next_x, next_y, next_z, next_places, next_degenerate};
                        number[0] = sent;
                        sent = sent + 1;
                        if (stalls && sent == 225) more = 1'b0;
                    end
                end
                valid_in <= valid[0];
                port_v_x <= valid[0] ? next_v_x : 16'bx;
                port_v_y <= valid[0] ? next_v_y : 16'bx;
                port_v_z <= valid[0] ? next_v_z : 16'bx;
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
                $display("mismatch: normalise_vectors.txt holds %0d vectors and should hold %0d", passed, VECTORS);
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
