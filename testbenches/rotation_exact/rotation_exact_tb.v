// rotation: turns a direction in polar form into the frame of a surface normal
// made by fixpath 0.1.0; Lee et al., An Effective Hardware Architecture for Bump Mapping Using
// Angular Operation, section 3.1 and Fig. 7
//   variant=exact output=auto angle_bits=16 table_addr_bits=10 scheme=direct quarter_wave=off
//   frac_bits=16 int_bits=1 guard_bits=2 rounding=half-up overflow=saturate sincos_addr_bits=auto
//   asin_addr_bits=auto recip_addr_bits=auto atan_addr_bits=auto prop_addr_bits=auto
//   recip_int_bits=8 atan_int_bits=auto quadrants=full cordic_iterations=auto period_ps=5000
//   stages=auto rom=block
// latency 3 cycles, interval 1 cycle; tables read on the clock
// absolute errors against the golden model of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst case:
//   angle: mean 1.41e-3 rad, largest seen 4.85e-3 rad at phi_a=471 theta_a=18178 phi_n=31386 theta_n=13058
//   dot: mean 1.65e-3, largest seen 4.85e-3 at phi_a=471 theta_a=18178 phi_n=31386 theta_n=13058
//   x: mean 9.18e-4, largest seen 4.10e-3 (268.8 ulp) at phi_a=29150 theta_a=16832 phi_n=13217 theta_n=8896
//   y: mean 7.11e-4, largest seen 2.97e-3 (194.4 ulp) at phi_a=63595 theta_a=15808 phi_n=31274 theta_n=12249
//   z: mean 8.46e-4, largest seen 3.82e-3 (250.3 ulp) at phi_a=1717 theta_a=16513 phi_n=13490 theta_n=25983
// stated bound on each component: 6.05e-3
//
// Self-checking testbench of rotation_exact.
// Each line of rotation_exact_vectors.txt holds the input words and then the
// expected output words, in hexadecimal. The first pass sends all vectors without stalls, one
// per cycle. The second pass sends the first 358 again with stalls and gaps,
// with a reset in mid-stream. Every bit of every output and the latency are compared.
// The last line says PASS or FAIL; a failure ends with a nonzero status.
// With +vcd the testbench writes rotation_exact_tb.vcd.
module rotation_exact_tb;
    localparam LATENCY = 3;
    localparam VECTORS = 358;
    localparam SHOWN = 10; // of the mismatches

    reg clk = 1'b0;
    reg rst = 1'b1;
    reg ce = 1'b1;
    reg valid_in = 1'b0;
    wire valid_out;
    // The prefix port_ keeps the ports' names apart from the names used here.
    reg [-1:-16] port_phi_a;
    reg [-1:-16] port_theta_a;
    reg [-1:-16] port_phi_n;
    reg [-1:-16] port_theta_n;
    wire signed [1:-16] port_x;
    wire signed [1:-16] port_y;
    wire signed [1:-16] port_z;

    rotation_exact dut (
        .clk(clk), .rst(rst), .ce(ce),
        .valid_in(valid_in), .valid_out(valid_out),
        .phi_a(port_phi_a),
        .theta_a(port_theta_a),
        .phi_n(port_phi_n),
        .theta_n(port_theta_n),
        .x(port_x),
        .y(port_y),
        .z(port_z)
    );

    // Expected outputs, shifted along with the pipeline; entry 0 belongs to the current inputs.
    reg [53:0] expected [0:LATENCY];
    reg valid [0:LATENCY];
    integer number [0:LATENCY];

    integer file, fields, sent, checked, mismatches, passed, i;
    reg more, stalls, reset_done, started;
    reg [31:0] lfsr; // decides on stalls and gaps
    reg [-1:-16] next_phi_a;
    reg [-1:-16] next_theta_a;
    reg [-1:-16] next_phi_n;
    reg [-1:-16] next_theta_n;
    reg signed [1:-16] next_x;
    reg signed [1:-16] next_y;
    reg signed [1:-16] next_z;

    always #5 clk = ~clk;

    initial begin
        if ($test$plusargs("vcd")) begin
            $dumpfile("rotation_exact_tb.vcd");
            $dumpvars(0, rotation_exact_tb);
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
            file = $fopen("rotation_exact_vectors.txt", "r");
            if (file == 0) begin
                $display("FAIL: rotation_exact_vectors.txt can't be read");
                finish_failed;
            end
        end
    endtask

    task read_vector;
        begin
            fields = $fscanf(file, "%h %h %h %h %h %h %h ", next_phi_a, next_theta_a, next_phi_n, next_theta_n, next_x, next_y, next_z);
            more = fields == 7;
            if (!more && fields > 0) begin
                mismatches = mismatches + 1;
                $display("mismatch: rotation_exact_vectors.txt is cut short after vector %0d", sent);
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
                if (port_x !== expected[LATENCY][53:36]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d x expected %h got %h",
                            number[LATENCY], expected[LATENCY][53:36], port_x);
                end
                if (port_y !== expected[LATENCY][35:18]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d y expected %h got %h",
                            number[LATENCY], expected[LATENCY][35:18], port_y);
                end
                if (port_z !== expected[LATENCY][17:0]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d z expected %h got %h",
                            number[LATENCY], expected[LATENCY][17:0], port_z);
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
                        expected[0] = {next_x, next_y, next_z};
                        number[0] = sent;
                        sent = sent + 1;
                        if (stalls && sent == 358) more = 1'b0;
                    end
                end
                valid_in <= valid[0];
                port_phi_a <= valid[0] ? next_phi_a : 16'bx;
                port_theta_a <= valid[0] ? next_theta_a : 16'bx;
                port_phi_n <= valid[0] ? next_phi_n : 16'bx;
                port_theta_n <= valid[0] ? next_theta_n : 16'bx;
            end
            // A reset in mid-stream takes effect despite the stall: words in flight are lost.
            if (stalls && !reset_done && sent == 358 / 2) begin
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
                $display("mismatch: rotation_exact_vectors.txt holds %0d vectors and should hold %0d", passed, VECTORS);
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
