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
module rotation_corrected_shared (
    input  wire clk,
    input  wire rst, // clears the valid bits and the phase
    input  wire ce, // the pipeline stands still without
    input  wire valid_in,
    output wire ready, // inputs are taken at this edge
    input  wire [-1:-16] phi_a, // u16f16
    input  wire [-1:-16] theta_a, // u16f16
    input  wire [-1:-16] phi_n, // u16f16
    input  wire [-1:-16] theta_n, // u16f16
    output wire valid_out,
    output reg  [-1:-16] phi, // u16f16
    output reg  [-1:-16] theta // u16f16
);

    // table sincos: sin s20f18, cos s20f18
    (* rom_style = "block" *)
    reg [39:0] sincos_rom [0:1023];
    initial $readmemh("rotation_corrected_shared_sincos.hex", sincos_rom);

    // table asin: asin s18f18
    (* rom_style = "block" *)
    reg [17:0] asin_rom [0:1023];
    initial $readmemh("rotation_corrected_shared_asin.hex", asin_rom);

    // table recip_sin: half_recip_sin s27f18
    (* rom_style = "block" *)
    reg [26:0] recip_sin_rom [0:1023];
    initial $readmemh("rotation_corrected_shared_recip_sin.hex", recip_sin_rom);

    // table recip_cos: half_recip_cos s27f18
    (* rom_style = "block" *)
    reg [26:0] recip_cos_rom [0:1023];
    initial $readmemh("rotation_corrected_shared_recip_cos.hex", recip_cos_rom);

    // table atan: atan s18f18
    (* rom_style = "block" *)
    reg [17:0] atan_rom [0:1023];
    initial $readmemh("rotation_corrected_shared_atan.hex", atan_rom);

    // table prop: prop s20f18
    (* rom_style = "block" *)
    reg [19:0] prop_rom [0:1023];
    initial $readmemh("rotation_corrected_shared_prop.hex", prop_rom);

    // ---- phase ----
    reg [1:0] phase;
    wire [1:0] phase_more = phase + 2'h1;
    wire phase_last = phase == 2'h2;
    wire [1:0] phase_next = phase_last ? 2'h0 : phase_more;
    wire phase_0 = phase == 2'h0;
    wire phase_1 = phase == 2'h1;
    wire phase_2 = phase == 2'h2;

    always @(posedge clk)
        if (rst) phase <= 2'h0;
        else if (ce) phase <= phase_next;

    // ---- hold registers and results of units ----
    reg [-1:-16] theta_n_s1; // u16f16
    reg [-1:-16] theta_n_s4; // u16f16
    reg signed [1:-19] n17_s2; // s21f19
    reg behind_s1; // u1f0
    reg [-1:-18] theta_x_s4; // u18f18
    reg signed [2:-18] y_double_s2; // s21f18
    reg signed [2:-18] y_double_s5; // s21f18
    reg signed [8:-18] recip_sin_half_recip_sin_s6; // s27f18
    reg signed [8:-18] recip_cos_half_recip_cos_s6; // s27f18
    wire signed [11:-36] n38; // s48f36
    reg signed [11:-36] n38_s8; // s48f36
    reg n43_s5; // u1f0
    reg n43_s8; // u1f0
    wire signed [11:-36] n46; // s48f36
    reg signed [11:-36] n46_s7; // s48f36
    reg [-1:-18] n50_s5; // u18f18
    reg [-1:-18] n50_s8; // u18f18
    reg [-1:-18] n50_s11; // u18f18
    reg signed [1:-18] prop_theta_prop_s9; // s20f18
    reg signed [0:-18] n54_s5; // s19f18
    reg signed [0:-18] n54_s8; // s19f18
    reg signed [0:-18] n54_s11; // s19f18
    wire signed [2:-36] n55; // s39f36
    reg signed [2:-36] n55_s12; // s39f36
    reg [-1:-16] phi_next_s10; // u16f16

    // ---- stage 0 ----
    // angles
    wire signed [0:-16] angles_delta_exact = {1'b0, phi_a} - {1'b0, phi_n}; // s17f16
    wire [-1:-16] angles_delta = angles_delta_exact[-1:-16]; // u16f16
    wire [0:-16] angles_n6 = {1'b0, theta_a} + {1'b0, angles_delta}; // u17f16
    wire signed [0:-16] angles_n7 = {1'b0, theta_a} - {1'b0, angles_delta}; // s17f16
    wire [-1:-16] angles_ang_x = angles_n6[-1:-16]; // u16f16
    wire [-1:-16] angles_ang_y = angles_n7[-1:-16]; // u16f16
    // sincos
    wire [9:0] sincos_n10 = angles_ang_x[-1:-10]; // u10f0
    wire [9:0] sincos_n13 = angles_ang_y[-1:-10]; // u10f0
    // (unit)
    wire [-1:-16] n21 = 16'h4000; // u16f16
    wire [-1:-16] n22 = 16'hc000; // u16f16
    wire n23 = n21 < theta_a; // u1f0
    wire n24 = theta_a < n22; // u1f0
    wire behind = n23 & n24; // u1f0
    wire [-1:-18] n28 = 18'h20000; // u18f18
    wire n53 = 1'b1; // u1f2

    reg [39:0] sincos_row;
    reg [39:0] sincos_row_2;
    always @(posedge clk)
        if (ce & phase_0) begin
            theta_n_s1 <= theta_n;
            behind_s1 <= behind;
        end
    always @(posedge clk)
        if (ce) begin
            sincos_row <= sincos_rom[sincos_n10];
            sincos_row_2 <= sincos_rom[sincos_n13];
        end
    reg valid_s1;
    always @(posedge clk)
        if (rst) valid_s1 <= 1'b0;
        else if (ce & phase_0) valid_s1 <= valid_in;

    // ---- stage 1 ----
    // sincos
    wire signed [1:-18] sincos_sin_x = sincos_row[39:20]; // s20f18
    wire signed [1:-18] sincos_cos_x = sincos_row[19:0]; // s20f18
    wire signed [1:-18] sincos_sin_y = sincos_row_2[39:20]; // s20f18
    wire signed [1:-18] sincos_cos_y = sincos_row_2[19:0]; // s20f18
    // (unit)
    wire signed [2:-18] n16 = {sincos_sin_x[1], sincos_sin_x} + {sincos_sin_y[1], sincos_sin_y}; // s21f18
    wire signed [1:-19] n17 = n16; // s21f19
    wire signed [2:-18] y_double = {sincos_cos_y[1], sincos_cos_y} - {sincos_cos_x[1], sincos_cos_x}; // s21f18

    always @(posedge clk)
        if (ce & phase_1) begin
            n17_s2 <= n17;
            y_double_s2 <= y_double;
        end

    // ---- stage 2 ----
    wire signed [2:-19] sin_theta_x_sum = {n17_s2[1], n17_s2} + 22'h1;
    wire signed [2:-18] sin_theta_x_cut = sin_theta_x_sum[2:-18];
    wire sin_theta_x_over = ~sin_theta_x_cut[2] & (|sin_theta_x_cut[1:0]);
    wire sin_theta_x_under = sin_theta_x_cut[2] & ~(&sin_theta_x_cut[1:0]);
    wire signed [0:-18] sin_theta_x = sin_theta_x_over ? 19'h3ffff : sin_theta_x_under ? 19'h40000 : sin_theta_x_cut[0:-18]; // s19f18
    // asin
    wire [9:0] asin_n19 = sin_theta_x[0:-9]; // u10f0

    reg [17:0] asin_row;
    always @(posedge clk)
        if (ce) begin
            asin_row <= asin_rom[asin_n19];
        end

    // ---- stage 3 ----
    // asin
    wire signed [-1:-18] asin_n20 = asin_row; // s18f18
    // (unit)
    wire signed [0:-18] n26 = -{asin_n20[-1], asin_n20}; // s19f18
    wire [-1:-18] n27 = n26[-1:-18]; // u18f18
    wire [-1:-18] n29 = n27 ^ n28; // u18f18
    wire [-1:-18] n30 = asin_n20; // u18f18
    wire [-1:-18] theta_x = behind_s1 ? n29 : n30; // u18f18

    always @(posedge clk)
        if (ce & phase_0) begin
            theta_n_s4 <= theta_n_s1;
            theta_x_s4 <= theta_x;
        end
    reg valid_s4;
    always @(posedge clk)
        if (rst) valid_s4 <= 1'b0;
        else if (ce & phase_0) valid_s4 <= valid_s1;

    // ---- stage 4 ----
    wire signed [0:-18] z_exact = {1'b0, theta_x_s4} - {1'b0, theta_n_s4, 2'h0}; // s19f18
    wire signed [-1:-18] ang_z = z_exact[-1:-18]; // s18f18
    // recip_sin
    wire [9:0] recip_sin_n35 = ang_z[-1:-10]; // u10f0
    // (unit)
    wire n43 = ang_z[-1]; // u1f0
    wire [-1:-18] n50_neg = -ang_z;
    wire [-1:-18] n50 = ang_z[-1] ? n50_neg : ang_z; // u18f18
    wire signed [0:-18] n54 = {2'h0, n53, 16'h0} - {1'b0, n50}; // s19f18

    reg [26:0] recip_sin_row;
    reg [26:0] recip_cos_row;
    always @(posedge clk)
        if (ce & phase_1) begin
            y_double_s5 <= y_double_s2;
            n43_s5 <= n43;
            n50_s5 <= n50;
            n54_s5 <= n54;
        end
    always @(posedge clk)
        if (ce) begin
            recip_sin_row <= recip_sin_rom[recip_sin_n35];
            recip_cos_row <= recip_cos_rom[recip_sin_n35];
        end

    // ---- stage 5 ----
    // recip_sin
    wire signed [8:-18] recip_sin_half_recip_sin = recip_sin_row; // s27f18
    // recip_cos
    wire signed [8:-18] recip_cos_half_recip_cos = recip_cos_row; // s27f18

    always @(posedge clk)
        if (ce & phase_2) begin
            recip_sin_half_recip_sin_s6 <= recip_sin_half_recip_sin;
            recip_cos_half_recip_cos_s6 <= recip_cos_half_recip_cos;
        end

    // ---- stage 6 ----

    always @(posedge clk)
        if (ce & phase_0) begin
            n46_s7 <= n46;
        end
    reg valid_s7;
    always @(posedge clk)
        if (rst) valid_s7 <= 1'b0;
        else if (ce & phase_0) valid_s7 <= valid_s4;

    // ---- stage 7 ----
    wire signed [12:-36] y_k_sum = {n46_s7[11], n46_s7} + 49'h20000;
    wire signed [12:-18] y_k_cut = y_k_sum[12:-18];
    wire y_k_over = ~y_k_cut[12] & (|y_k_cut[11:0]);
    wire y_k_under = y_k_cut[12] & ~(&y_k_cut[11:0]);
    wire signed [0:-18] y_k = y_k_over ? 19'h3ffff : y_k_under ? 19'h40000 : y_k_cut[0:-18]; // s19f18
    wire [0:-18] n48_neg = -y_k;
    wire [0:-18] n48 = y_k[0] ? n48_neg : y_k; // u19f18
    wire n49_over = |n48[0];
    wire [-1:-18] n49 = n49_over ? 18'h3ffff : n48[-1:-18]; // u18f18
    // prop
    wire [9:0] prop_n51 = n49[-1:-10]; // u10f0

    reg [19:0] prop_row;
    always @(posedge clk)
        if (ce & phase_1) begin
            n38_s8 <= n38;
            n43_s8 <= n43_s5;
            n50_s8 <= n50_s5;
            n54_s8 <= n54_s5;
        end
    always @(posedge clk)
        if (ce) begin
            prop_row <= prop_rom[prop_n51];
        end

    // ---- stage 8 ----
    wire signed [12:-36] tan_phi_sum = {n38_s8[11], n38_s8} + 49'h20000;
    wire signed [12:-18] tan_phi_cut = tan_phi_sum[12:-18];
    wire tan_phi_over = ~tan_phi_cut[12] & (|tan_phi_cut[11:4]);
    wire tan_phi_under = tan_phi_cut[12] & ~(&tan_phi_cut[11:4]);
    wire signed [4:-18] tan_phi = tan_phi_over ? 23'h3fffff : tan_phi_under ? 23'h400000 : tan_phi_cut[4:-18]; // s23f18
    // atan
    wire [9:0] atan_n40 = tan_phi[4:-5]; // u10f0
    // prop
    wire signed [1:-18] prop_theta_prop = prop_row; // s20f18

    reg [17:0] atan_row;
    always @(posedge clk)
        if (ce) begin
            atan_row <= atan_rom[atan_n40];
        end
    always @(posedge clk)
        if (ce & phase_2) begin
            prop_theta_prop_s9 <= prop_theta_prop;
        end

    // ---- stage 9 ----
    // atan
    wire signed [-1:-18] atan_n41 = atan_row; // s18f18
    // (unit)
    wire [-1:-18] n42 = atan_n41; // u18f18
    wire [-1:-18] n44 = n42 ^ n28; // u18f18
    wire [-1:-18] n45 = n43_s8 ? n44 : n42; // u18f18
    wire [0:-18] n57_sum = {1'b0, n45} + 19'h2;
    wire [0:-16] n57_cut = n57_sum[0:-16];
    wire [0:-16] n57 = n57_cut; // u17f16
    wire [-1:-16] phi_next = n57[-1:-16]; // u16f16

    always @(posedge clk)
        if (ce & phase_0) begin
            phi_next_s10 <= phi_next;
        end
    reg valid_s10;
    always @(posedge clk)
        if (rst) valid_s10 <= 1'b0;
        else if (ce & phase_0) valid_s10 <= valid_s7;

    // ---- stage 10 ----

    always @(posedge clk)
        if (ce & phase_1) begin
            n50_s11 <= n50_s8;
            n54_s11 <= n54_s8;
        end

    // ---- stage 11 ----

    always @(posedge clk)
        if (ce & phase_2) begin
            n55_s12 <= n55;
        end

    // ---- stage 12 ----
    wire signed [3:-36] n56 = {4'h0, n50_s11, 18'h0} + {n55_s12[2], n55_s12}; // s40f36
    wire signed [4:-36] n59_sum = {n56[3], n56} + 41'h80000;
    wire signed [4:-16] n59_cut = n59_sum[4:-16];
    wire signed [4:-16] n59 = n59_cut; // s21f16
    wire [-1:-16] theta_next = n59[-1:-16]; // u16f16

    always @(posedge clk)
        if (ce & phase_0) begin
            phi <= phi_next_s10;
            theta <= theta_next;
        end
    reg valid_s13;
    always @(posedge clk)
        if (rst) valid_s13 <= 1'b0;
        else if (ce & phase_0) valid_s13 <= valid_s10;
    assign valid_out = valid_s13 & phase_1;

    // ---- inputs of mul1 ----
    wire signed [2:-18] mul1_in0 = phase_2 ? {{2{n54_s11[0]}}, n54_s11} : y_double_s5; // s21f18
    wire signed [8:-18] mul1_in1 = phase_1 ? recip_sin_half_recip_sin_s6 : phase_2 ? {{7{prop_theta_prop_s9[1]}}, prop_theta_prop_s9} : recip_cos_half_recip_cos_s6; // s27f18

    // ---- mul1, stage 0 ----
    wire signed [11:-36] mul1_n0 = mul1_in0 * mul1_in1; // s48f36

    // ---- results of mul1 ----
    assign n38 = mul1_n0;
    assign n46 = mul1_n0;
    assign n55 = mul1_n0[2:-36];

    assign ready = phase_0;

    // bits that rounding and cutting drop
    wire unused = &{1'b0,
        angles_delta_exact[0],
        angles_n6[0],
        angles_n7[0],
        angles_ang_x[-11:-16],
        angles_ang_y[-11:-16],
        sin_theta_x[-10:-18],
        sin_theta_x_sum[-19],
        n26[0],
        z_exact[0],
        y_k_sum[-19:-36],
        n49[-11:-18],
        tan_phi[-6:-18],
        tan_phi_sum[-19:-36],
        n57[0],
        n57_sum[-17:-18],
        n59[4:0],
        n59_sum[-17:-36]};
endmodule
