// rotation: turns a direction in polar form into the frame of a surface normal
// made by fixpath 0.1.0; Lee et al., An Effective Hardware Architecture for Bump Mapping Using
// Angular Operation, section 3.1 and Fig. 7
//   variant=corrected output=auto angle_bits=16 table_addr_bits=10 scheme=direct quarter_wave=off
//   frac_bits=16 int_bits=1 guard_bits=2 rounding=half-up overflow=saturate sincos_addr_bits=auto
//   asin_addr_bits=auto recip_addr_bits=auto atan_addr_bits=auto prop_addr_bits=auto
//   recip_int_bits=8 atan_int_bits=auto quadrants=full cordic_iterations=auto period_ps=5000
//   stages=auto rom=block schedule=shared interval=auto share_dot=auto share_mul=1 share_add=auto
//   share_table=auto share_root=auto share_divide=auto share_latency=auto share_loads=no
// latency 13 cycles, interval 3 cycles; tables read on the clock
// absolute errors against the golden model of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst case:
//   angle: mean 2.96e-1 rad, largest seen 1.03e0 rad at phi_a=63191 theta_a=16419 phi_n=6223 theta_n=16703
//   dot: mean 2.93e-1, largest seen 9.83e-1 at phi_a=63191 theta_a=16419 phi_n=6223 theta_n=16703
//   x: mean 1.90e-1, largest seen 7.70e-1 at phi_a=34757 theta_a=16352 phi_n=57388 theta_n=19960
//   y: mean 6.21e-2, largest seen 2.97e-1 at phi_a=12448 theta_a=16689 phi_n=28272 theta_n=16284
//   z: mean 1.80e-1, largest seen 7.54e-1 at phi_a=46723 theta_a=16419 phi_n=40254 theta_n=12730
// no bound is stated: asin, 1/sin and 1/cos have infinite slopes, so no word length bounds the error; each table's own error is stated
//
// Self-checking testbench of rotation_corrected_shared.
// Each line of rotation_corrected_shared_vectors.txt holds the input words and then the
// expected output words, in hexadecimal. The first pass sends all vectors without stalls, one
// every 3 cycles when the module is ready, with words that it must ignore in between.
// The second pass sends the first 358 again with stalls and gaps,
// with a reset in mid-stream. Every bit of every output and the latency are compared.
// The last line says PASS or FAIL; a failure ends with a nonzero status.
// With +vcd the testbench writes rotation_corrected_shared_tb.vcd.
module rotation_corrected_shared_tb;
    localparam LATENCY = 13;
    localparam INTERVAL = 3;
    localparam VECTORS = 358;
    localparam SHOWN = 10; // of the mismatches

    reg clk = 1'b0;
    reg rst = 1'b1;
    reg ce = 1'b1;
    reg valid_in = 1'b0;
    wire valid_out;
    wire ready;
    // The prefix port_ keeps the ports' names apart from the names used here.
    reg [-1:-16] port_phi_a;
    reg [-1:-16] port_theta_a;
    reg [-1:-16] port_phi_n;
    reg [-1:-16] port_theta_n;
    wire [-1:-16] port_phi;
    wire [-1:-16] port_theta;

    rotation_corrected_shared dut (
        .clk(clk), .rst(rst), .ce(ce),
        .valid_in(valid_in), .valid_out(valid_out),
        .ready(ready),
        .phi_a(port_phi_a),
        .theta_a(port_theta_a),
        .phi_n(port_phi_n),
        .theta_n(port_theta_n),
        .phi(port_phi),
        .theta(port_theta)
    );

    // Expected outputs, shifted along with the pipeline; entry 0 belongs to the current inputs.
    reg [31:0] expected [0:LATENCY];
    reg valid [0:LATENCY];
    integer number [0:LATENCY];

    integer file, fields, sent, checked, mismatches, passed, i;
    reg more, stalls, reset_done, started;
    integer phase; // as the module should count it
    reg [31:0] lfsr; // decides on stalls and gaps
    reg [-1:-16] next_phi_a;
    reg [-1:-16] next_theta_a;
    reg [-1:-16] next_phi_n;
    reg [-1:-16] next_theta_n;
    reg [-1:-16] next_phi;
    reg [-1:-16] next_theta;

    always #5 clk = ~clk;

    initial begin
        if ($test$plusargs("vcd")) begin
            $dumpfile("rotation_corrected_shared_tb.vcd");
            $dumpvars(0, rotation_corrected_shared_tb);
        end
        lfsr = 32'h2545f491;
        mismatches = 0;
        passed = 0;
        phase = 0;
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
            file = $fopen("rotation_corrected_shared_vectors.txt", "r");
            if (file == 0) begin
                $display("FAIL: rotation_corrected_shared_vectors.txt can't be read");
                finish_failed;
            end
        end
    endtask

    task read_vector;
        begin
            fields = $fscanf(file, "%h %h %h %h %h %h ", next_phi_a, next_theta_a, next_phi_n, next_theta_n, next_phi, next_theta);
            more = fields == 6;
            if (!more && fields > 0) begin
                mismatches = mismatches + 1;
                $display("mismatch: rotation_corrected_shared_vectors.txt is cut short after vector %0d", sent);
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
            if (started && ready !== (phase == 0)) begin
                mismatches = mismatches + 1;
                if (mismatches <= SHOWN)
                    $display("mismatch: vector %0d ready expected %b got %b", sent, phase == 0, ready);
            end
            // Each word is checked once: in a cycle with ce, after which the pipeline advances.
            if (ce && valid[LATENCY]) begin
                if (port_phi !== expected[LATENCY][31:16]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d phi expected %h got %h",
                            number[LATENCY], expected[LATENCY][31:16], port_phi);
                end
                if (port_theta !== expected[LATENCY][15:0]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d theta expected %h got %h",
                            number[LATENCY], expected[LATENCY][15:0], port_theta);
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
            if (rst) phase = 0;
            else if (ce) phase = (phase + 1) % INTERVAL;
        end
    endtask

    // Sets the inputs after this edge. They don't change while the pipeline is stalled.
    task drive;
        begin
            lfsr = {lfsr[30:0], lfsr[31] ^ lfsr[21] ^ lfsr[1] ^ lfsr[0]};
            rst <= 1'b0;
            ce <= !(stalls && lfsr[2:0] == 3'd0);
            if (ce || !valid[0]) begin
                valid[0] = 1'b0;
                if (phase == 0 && more && !(stalls && lfsr[5:3] == 3'd0)) begin
                    read_vector;
                    if (more) begin
                        valid[0] = 1'b1;
                        expected[0] = {next_phi, next_theta};
                        number[0] = sent;
                        sent = sent + 1;
                        if (stalls && sent == 358) more = 1'b0;
                    end
                end
                valid_in <= valid[0] || (phase != 0 && lfsr[6]);
                port_phi_a <= valid[0] ? next_phi_a : 16'bx;
                port_theta_a <= valid[0] ? next_theta_a : 16'bx;
                port_phi_n <= valid[0] ? next_phi_n : 16'bx;
                port_theta_n <= valid[0] ? next_theta_n : 16'bx;
            end
            // A reset in mid-stream takes effect despite the stall: words in flight are lost.
            if (stalls && !reset_done && sent == 358 / 2 && phase == INTERVAL / 2) begin
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
                $display("mismatch: rotation_corrected_shared_vectors.txt holds %0d vectors and should hold %0d", passed, VECTORS);
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
