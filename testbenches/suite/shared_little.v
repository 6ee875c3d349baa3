// under test
module little (
    input  wire clk,
    input  wire rst, // clears the valid bits and the phase
    input  wire ce, // the pipeline stands still without
    input  wire valid_in,
    output wire ready, // inputs are taken at this edge
    input  wire signed [1:-4] x, // s6f4
    input  wire signed [1:-4] y, // s6f4
    output wire valid_out,
    output reg  signed [4:-8] sum, // s13f8
    output reg  signed [1:-4] passed // s6f4
);

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
    reg signed [1:-4] x_s1; // s6f4
    reg signed [1:-4] x_s4; // s6f4
    reg signed [1:-4] y_s1; // s6f4
    reg signed [1:-4] y_s4; // s6f4
    reg signed [1:-4] y_s7; // s6f4
    wire signed [3:-8] square; // s12f8
    reg signed [3:-8] square_s4; // s12f8
    reg signed [1:-4] narrow_s5; // s6f4
    wire signed [3:-8] cube; // s12f8
    reg signed [3:-8] cube_s8; // s12f8
    wire signed [3:-8] both; // s12f8
    reg signed [3:-8] both_s9; // s12f8

    // ---- stage 0 ----

    always @(posedge clk)
        if (ce & phase_0) begin
            x_s1 <= x;
            y_s1 <= y;
        end
    reg valid_s1;
    always @(posedge clk)
        if (rst) valid_s1 <= 1'b0;
        else if (ce & phase_0) valid_s1 <= valid_in;

    // ---- stage 3 ----

    always @(posedge clk)
        if (ce & phase_0) begin
            x_s4 <= x_s1;
            y_s4 <= y_s1;
            square_s4 <= square;
        end
    reg valid_s4;
    always @(posedge clk)
        if (rst) valid_s4 <= 1'b0;
        else if (ce & phase_0) valid_s4 <= valid_s1;

    // ---- stage 4 ----
    wire signed [4:-8] narrow_sum = {square_s4[3], square_s4} + 13'h8;
    wire signed [4:-4] narrow_cut = narrow_sum[4:-4];
    wire narrow_over = ~narrow_cut[4] & (|narrow_cut[3:1]);
    wire narrow_under = narrow_cut[4] & ~(&narrow_cut[3:1]);
    wire signed [1:-4] narrow = narrow_over ? 6'h1f : narrow_under ? 6'h20 : narrow_cut[1:-4]; // s6f4

    always @(posedge clk)
        if (ce & phase_1) begin
            narrow_s5 <= narrow;
        end

    // ---- stage 6 ----

    always @(posedge clk)
        if (ce & phase_0) begin
            y_s7 <= y_s4;
        end
    reg valid_s7;
    always @(posedge clk)
        if (rst) valid_s7 <= 1'b0;
        else if (ce & phase_0) valid_s7 <= valid_s4;

    // ---- stage 7 ----

    always @(posedge clk)
        if (ce & phase_1) begin
            cube_s8 <= cube;
        end

    // ---- stage 8 ----

    always @(posedge clk)
        if (ce & phase_2) begin
            both_s9 <= both;
        end

    // ---- stage 9 ----
    wire signed [4:-8] n6 = {cube_s8[3], cube_s8} + {both_s9[3], both_s9}; // s13f8

    always @(posedge clk)
        if (ce & phase_0) begin
            passed <= y_s7;
            sum <= n6;
        end
    reg valid_s10;
    always @(posedge clk)
        if (rst) valid_s10 <= 1'b0;
        else if (ce & phase_0) valid_s10 <= valid_s7;
    assign valid_out = valid_s10 & phase_1;

    // ---- inputs of mul1 ----
    wire signed [1:-4] mul1_in0_next = phase_1 ? narrow : x; // s6f4
    wire phase_0_1 = phase_0 | phase_1;
    wire signed [1:-4] mul1_in1_next = phase_1 ? x_s4 : phase_2 ? y_s4 : x; // s6f4

    reg signed [1:-4] mul1_in0; // s6f4
    reg signed [1:-4] mul1_in1; // s6f4
    always @(posedge clk)
        if (ce & phase_0_1) begin
            mul1_in0 <= mul1_in0_next;
        end
    always @(posedge clk)
        if (ce) begin
            mul1_in1 <= mul1_in1_next;
        end

    // ---- mul1, stage 0 ----
    wire signed [3:-8] mul1_n0 = mul1_in0 * mul1_in1; // s12f8

    reg signed [3:-8] mul1_n0_s1; // s12f8
    always @(posedge clk)
        if (ce) begin
            mul1_n0_s1 <= mul1_n0;
        end

    // ---- mul1, stage 1 ----

    reg signed [3:-8] mul1_n0_s2; // s12f8
    always @(posedge clk)
        if (ce) begin
            mul1_n0_s2 <= mul1_n0_s1;
        end

    // ---- results of mul1 ----
    assign square = mul1_n0_s2;
    assign cube = mul1_n0_s2;
    assign both = mul1_n0_s2;

    assign ready = phase_0;

    // bits that rounding and cutting drop
    wire unused = &{1'b0,
        narrow_s5,
        narrow_sum[-5:-8]};
endmodule
