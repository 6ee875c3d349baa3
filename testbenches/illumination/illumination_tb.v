// illumination: light of a pixel from light, halfway and perturbed normal vector in the texture frame
// made by fixpath 0.1.0; seed 001 (Lee et al.), sections 3.2 and 4.2, Fig. 8; variant kim: its eqs (3) and (4)
//   variant=corrected angle_bits=16 table_addr_bits=10 scheme=direct quarter_wave=off frac_bits=16
//   guard_bits=2 rounding=half-up sincos_addr_bits=auto cos_addr_bits=auto highlight=on
//   diffuse_addr_bits=10 specular_addr_bits=10 light_scheme=direct light_bits=16 ambient=0.1
//   diffuse=0.6 specular=0.3 exponent=32 period_ps=5000 stages=auto rom=block
// latency 6 cycles, interval 1 cycle; tables read on the clock
// absolute errors against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   intensity: mean 3.82e-4, largest seen 6.81e-3 (446.6 ulp) at phi_lt=37053 theta_lt=4180 phi_ht=35367 theta_ht=8197 phi_p=34886 theta_p=6598
//   diffuse: mean 3.22e-4, largest seen 2.59e-3 (169.6 ulp) at phi_lt=54705 theta_lt=16284 phi_ht=62205 theta_ht=13786 phi_p=39476 theta_p=7521
//   specular: mean 9.58e-5, largest seen 6.87e-3 (450.0 ulp) at phi_lt=9407 theta_lt=14751 phi_ht=20560 theta_ht=8847 phi_p=19346 theta_p=7827
//   dot_l: mean 1.03e-3, largest seen 4.01e-3 (262.7 ulp) at phi_lt=9033 theta_lt=16932 phi_ht=2260 theta_ht=13923 phi_p=24522 theta_p=8033
//   dot_h: mean 1.03e-3, largest seen 3.98e-3 (260.8 ulp) at phi_lt=8635 theta_lt=24817 phi_ht=7806 theta_ht=14338 phi_p=58302 theta_p=9088
// stated bound on each dot: 9.08e-3
// stated bound on each diffuse: 5.76e-3
// stated bound on each specular: 8.05e-2
// stated bound on each intensity: 8.63e-2
//
// Self-checking testbench of illumination. It reads illumination_vectors.txt: per line the words of the
// inputs, then of the expected outputs, in hexadecimal. First all vectors go straight through,
// one a cycle; then, after a reset in mid-stream, the first 250 go again with stalls and
// gaps. Every bit of every output and the latency are compared. The last line says PASS or
// FAIL, and a failure ends with a status that isn't 0. With +vcd it writes illumination_tb.vcd.
module illumination_tb;
    localparam LATENCY = 6;
    localparam VECTORS = 250;
    localparam SHOWN = 10; // of the mismatches

    reg clk = 1'b0;
    reg rst = 1'b1;
    reg ce = 1'b1;
    reg valid_in = 1'b0;
    wire valid_out;
    // No port can have a name that stands here for something else.
    reg [-1:-16] port_phi_lt;
    reg [-1:-16] port_theta_lt;
    reg [-1:-16] port_phi_ht;
    reg [-1:-16] port_theta_ht;
    reg [-1:-16] port_phi_p;
    reg [-1:-16] port_theta_p;
    wire [-1:-16] port_intensity;
    wire [-1:-16] port_diffuse;
    wire [-1:-16] port_specular;

    illumination dut (
        .clk(clk), .rst(rst), .ce(ce),
        .valid_in(valid_in), .valid_out(valid_out),
        .phi_lt(port_phi_lt),
        .theta_lt(port_theta_lt),
        .phi_ht(port_phi_ht),
        .theta_ht(port_theta_ht),
        .phi_p(port_phi_p),
        .theta_p(port_theta_p),
        .intensity(port_intensity),
        .diffuse(port_diffuse),
        .specular(port_specular)
    );

    // What should come out, moving beside the pipeline; entry 0 belongs to what goes in.
    reg [47:0] expected [0:LATENCY];
    reg valid [0:LATENCY];
    integer number [0:LATENCY];

    integer file, fields, sent, checked, mismatches, passed, i;
    reg more, stalls, reset_done, started;
    reg [31:0] lfsr; // decides on stalls and gaps
    reg [-1:-16] next_phi_lt;
    reg [-1:-16] next_theta_lt;
    reg [-1:-16] next_phi_ht;
    reg [-1:-16] next_theta_ht;
    reg [-1:-16] next_phi_p;
    reg [-1:-16] next_theta_p;
    reg [-1:-16] next_intensity;
    reg [-1:-16] next_diffuse;
    reg [-1:-16] next_specular;

    always #5 clk = ~clk;

    initial begin
        if ($test$plusargs("vcd")) begin
            $dumpfile("illumination_tb.vcd");
            $dumpvars(0, illumination_tb);
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
            file = $fopen("illumination_vectors.txt", "r");
            if (file == 0) begin
                $display("FAIL: illumination_vectors.txt can't be read");
                finish_failed;
            end
        end
    endtask

    task read_vector;
        begin
            fields = $fscanf(file, "%h %h %h %h %h %h %h %h %h ", next_phi_lt, next_theta_lt, next_phi_ht, next_theta_ht, next_phi_p, next_theta_p, next_intensity, next_diffuse, next_specular);
            more = fields == 9;
            if (!more && fields > 0) begin
                mismatches = mismatches + 1;
                $display("mismatch: illumination_vectors.txt is cut short after vector %0d", sent);
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
                if (port_intensity !== expected[LATENCY][47:32]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d intensity expected %h got %h",
                            number[LATENCY], expected[LATENCY][47:32], port_intensity);
                end
                if (port_diffuse !== expected[LATENCY][31:16]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d diffuse expected %h got %h",
                            number[LATENCY], expected[LATENCY][31:16], port_diffuse);
                end
                if (port_specular !== expected[LATENCY][15:0]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d specular expected %h got %h",
                            number[LATENCY], expected[LATENCY][15:0], port_specular);
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
                        expected[0] = {next_intensity, next_diffuse, next_specular};
                        number[0] = sent;
                        sent = sent + 1;
                        if (stalls && sent == 250) more = 1'b0;
                    end
                end
                valid_in <= valid[0];
                port_phi_lt <= valid[0] ? next_phi_lt : 16'bx;
                port_theta_lt <= valid[0] ? next_theta_lt : 16'bx;
                port_phi_ht <= valid[0] ? next_phi_ht : 16'bx;
                port_theta_ht <= valid[0] ? next_theta_ht : 16'bx;
                port_phi_p <= valid[0] ? next_phi_p : 16'bx;
                port_theta_p <= valid[0] ? next_theta_p : 16'bx;
            end
            // A reset in mid-stream, which a stall doesn't hold up: what is on its way is forgotten.
            if (stalls && !reset_done && sent == 250 / 2) begin
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
                $display("mismatch: illumination_vectors.txt holds %0d vectors and should hold %0d", passed, VECTORS);
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
