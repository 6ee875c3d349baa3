-- kim: light of a bump-mapped pixel by a matrix of sines and cosines and polar dot products
-- made by fixpath 0.1.0; Kim et al. 2001: eqs (3), (4) of seed 001 (Lee et al.); the set-up is a reconstruction
--   conversion=table angle_bits=16 table_addr_bits=10 scheme=direct quarter_wave=off frac_bits=16
--   guard_bits=2 rounding=half-up sincos_addr_bits=auto recip_addr_bits=auto atan_addr_bits=auto
--   cordic_iterations=auto highlight=on diffuse_addr_bits=10 specular_addr_bits=10
--   light_scheme=direct light_bits=16 ambient=0.1 diffuse=0.6 specular=0.3 exponent=32
--   period_ps=5000 stages=auto rom=block
-- latency 30 cycles, interval 1 cycle; tables read on the clock
-- absolute errors against the golden of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst:
--   intensity: mean 6.91e-4, largest seen 1.28e-2 (836.5 ulp) at phi_l=12249 theta_l=10042 phi_h=25129 theta_h=12990 phi_n=27856 theta_n=18250 psi=18706 phi_p=19124 theta_p=3769
--   diffuse: mean 5.92e-4, largest seen 7.09e-3 (464.8 ulp) at phi_l=5887 theta_l=21190 phi_h=20694 theta_h=21693 phi_n=7057 theta_n=377 psi=41054 phi_p=32253 theta_p=7036
--   specular: mean 1.54e-4, largest seen 1.15e-2 (756.4 ulp) at phi_l=46792 theta_l=23943 phi_h=48621 theta_h=15295 phi_n=56540 theta_n=7516 psi=771 phi_p=53306 theta_p=8323
--   dot_l: mean 1.94e-3, largest seen 1.17e-2 (766.0 ulp) at phi_l=5887 theta_l=21190 phi_h=20694 theta_h=21693 phi_n=7057 theta_n=377 psi=41054 phi_p=32253 theta_p=7036
--   dot_h: mean 1.93e-3, largest seen 1.09e-2 (713.0 ulp) at phi_l=60553 theta_l=18372 phi_h=64636 theta_h=22235 phi_n=8005 theta_n=19253 psi=1559 phi_p=20130 theta_p=8069
--   lt_angle: mean 2.77e-3 rad, largest seen 7.77e-3 rad at phi_l=6915 theta_l=10368 phi_h=4641 theta_h=3798 phi_n=44602 theta_n=12480 psi=59670 phi_p=22351 theta_p=3078
--   lt_dot: mean 2.77e-3, largest seen 7.77e-3 at phi_l=6915 theta_l=10368 phi_h=4641 theta_h=3798 phi_n=44602 theta_n=12480 psi=59670 phi_p=22351 theta_p=3078
--   lt_x: mean 1.43e-3, largest seen 7.31e-3 at phi_l=3004 theta_l=11455 phi_h=6745 theta_h=15411 phi_n=16385 theta_n=5769 psi=61008 phi_p=44796 theta_p=5705
--   lt_y: mean 1.26e-3, largest seen 6.21e-3 at phi_l=58622 theta_l=14345 phi_h=63015 theta_h=26871 phi_n=27904 theta_n=24597 psi=39862 phi_p=34182 theta_p=8142
--   lt_z: mean 1.47e-3, largest seen 6.89e-3 at phi_l=46077 theta_l=10290 phi_h=47299 theta_h=13859 phi_n=55937 theta_n=20227 psi=54458 phi_p=65410 theta_p=4451
--   ht_angle: mean 2.77e-3 rad, largest seen 7.83e-3 rad at phi_l=27736 theta_l=15792 phi_h=15742 theta_h=17078 phi_n=13120 theta_n=9730 psi=31698 phi_p=62952 theta_p=6764
--   ht_dot: mean 2.77e-3, largest seen 7.83e-3 at phi_l=27736 theta_l=15792 phi_h=15742 theta_h=17078 phi_n=13120 theta_n=9730 psi=31698 phi_p=62952 theta_p=6764
--   ht_x: mean 1.43e-3, largest seen 6.94e-3 at phi_l=60765 theta_l=22077 phi_h=12545 theta_h=23229 phi_n=26302 theta_n=28297 psi=58283 phi_p=51185 theta_p=7747
--   ht_y: mean 1.26e-3, largest seen 5.92e-3 at phi_l=17506 theta_l=13432 phi_h=12930 theta_h=16780 phi_n=13695 theta_n=13345 psi=2824 phi_p=40130 theta_p=3617
--   ht_z: mean 1.46e-3, largest seen 6.74e-3 at phi_l=15954 theta_l=3967 phi_h=34558 theta_h=10628 phi_n=23439 theta_n=21371 psi=29040 phi_p=61493 theta_p=6921
-- stated bound on each dot: 8.61e-2
-- stated bound on each diffuse: 5.20e-2
-- stated bound on each specular: 2.88e-1
-- stated bound on each intensity: 3.40e-1
-- stated bound on the angle: 7.10e-2 rad
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity kim is
    port (
        clk : in std_logic;
        rst : in std_logic; -- clears the valid bits
        ce : in std_logic; -- the pipeline stands still without
        valid_in : in std_logic;
        phi_l : in unsigned(15 downto 0); -- u16f16
        theta_l : in unsigned(15 downto 0); -- u16f16
        phi_h : in unsigned(15 downto 0); -- u16f16
        theta_h : in unsigned(15 downto 0); -- u16f16
        phi_n : in unsigned(15 downto 0); -- u16f16
        theta_n : in unsigned(15 downto 0); -- u16f16
        psi : in unsigned(15 downto 0); -- u16f16
        phi_p : in unsigned(15 downto 0); -- u16f16
        theta_p : in unsigned(15 downto 0); -- u16f16
        valid_out : out std_logic;
        intensity : out unsigned(15 downto 0) := (others => '0'); -- u16f16
        diffuse : out unsigned(15 downto 0) := (others => '0'); -- u16f16
        specular : out unsigned(15 downto 0) := (others => '0') -- u16f16
    );
end entity;

architecture rtl of kim is
    attribute rom_style : string;

    -- table sincos: sin s20f18, cos s20f18
    type sincos_rom_rows is array (0 to 1023) of unsigned(39 downto 0);
    impure function sincos_rom_file return sincos_rom_rows is
        file source : text open read_mode is "kim_sincos.hex";
        variable row : line;
        variable all_rows : sincos_rom_rows;
    begin
        for address in all_rows'range loop
            readline(source, row);
            hread(row, all_rows(address));
        end loop;
        return all_rows;
    end function;
    constant sincos_rom : sincos_rom_rows := sincos_rom_file;
    attribute rom_style of sincos_rom : constant is "block";

    -- table recip: recip u20f18
    type recip_rom_rows is array (0 to 1023) of unsigned(19 downto 0);
    impure function recip_rom_file return recip_rom_rows is
        file source : text open read_mode is "kim_recip.hex";
        variable row : line;
        variable all_rows : recip_rom_rows;
    begin
        for address in all_rows'range loop
            readline(source, row);
            hread(row, all_rows(address));
        end loop;
        return all_rows;
    end function;
    constant recip_rom : recip_rom_rows := recip_rom_file;
    attribute rom_style of recip_rom : constant is "block";

    -- table atan: atan u19f18, secant u19f18
    type atan_rom_rows is array (0 to 1023) of unsigned(37 downto 0);
    impure function atan_rom_file return atan_rom_rows is
        file source : text open read_mode is "kim_atan.hex";
        variable row : line;
        variable all_rows : atan_rom_rows;
    begin
        for address in all_rows'range loop
            readline(source, row);
            hread(row, all_rows(address));
        end loop;
        return all_rows;
    end function;
    constant atan_rom : atan_rom_rows := atan_rom_file;
    attribute rom_style of atan_rom : constant is "block";

    -- table diffuse: light u16f16
    type diffuse_rom_rows is array (0 to 1023) of unsigned(15 downto 0);
    impure function diffuse_rom_file return diffuse_rom_rows is
        file source : text open read_mode is "kim_diffuse.hex";
        variable row : line;
        variable all_rows : diffuse_rom_rows;
    begin
        for address in all_rows'range loop
            readline(source, row);
            hread(row, all_rows(address));
        end loop;
        return all_rows;
    end function;
    constant diffuse_rom : diffuse_rom_rows := diffuse_rom_file;
    attribute rom_style of diffuse_rom : constant is "block";

    -- table specular: light u16f16
    type specular_rom_rows is array (0 to 1023) of unsigned(15 downto 0);
    impure function specular_rom_file return specular_rom_rows is
        file source : text open read_mode is "kim_specular.hex";
        variable row : line;
        variable all_rows : specular_rom_rows;
    begin
        for address in all_rows'range loop
            readline(source, row);
            hread(row, all_rows(address));
        end loop;
        return all_rows;
    end function;
    constant specular_rom : specular_rom_rows := specular_rom_file;
    attribute rom_style of specular_rom : constant is "block";

    -- a copy of table sincos: sin s20f18, cos s20f18
    constant sincos_rom_2 : sincos_rom_rows := sincos_rom;
    attribute rom_style of sincos_rom_2 : constant is "block";

    -- a copy of table sincos: sin s20f18, cos s20f18
    constant sincos_rom_3 : sincos_rom_rows := sincos_rom;
    attribute rom_style of sincos_rom_3 : constant is "block";

    -- a copy of table sincos: sin s20f18, cos s20f18
    constant sincos_rom_4 : sincos_rom_rows := sincos_rom;
    attribute rom_style of sincos_rom_4 : constant is "block";

    -- a copy of table sincos: sin s20f18, cos s20f18
    constant sincos_rom_5 : sincos_rom_rows := sincos_rom;
    attribute rom_style of sincos_rom_5 : constant is "block";

    -- a copy of table recip: recip u20f18
    constant recip_rom_2 : recip_rom_rows := recip_rom;
    attribute rom_style of recip_rom_2 : constant is "block";

    -- a copy of table atan: atan u19f18, secant u19f18
    constant atan_rom_2 : atan_rom_rows := atan_rom;
    attribute rom_style of atan_rom_2 : constant is "block";

    -- a copy of table sincos: sin s20f18, cos s20f18
    constant sincos_rom_6 : sincos_rom_rows := sincos_rom;
    attribute rom_style of sincos_rom_6 : constant is "block";

    -- Words start at zero: numeric_std would warn of what it compares or looks up before.
    -- Valid bits don't, so that one that a reset misses shows as unknown.
    -- stage 0
    signal setup_frame_sincos_n9 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_frame_sincos_n12 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_light_sincos_n23 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_light_sincos_n26 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_light_azimuth_n69 : unsigned(18 downto 0) := (others => '0'); -- u19f18
    signal setup_light_azimuth_n73 : unsigned(18 downto 0) := (others => '0'); -- u19f18
    signal setup_half_sincos_n115 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_half_sincos_n118 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_n205 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal setup_phi_p : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal dot_l_sincos_n214 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal n236 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n245 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal n246 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal n257 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal n258 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal sincos_row : unsigned(39 downto 0) := (others => '0');
    signal sincos_row_2 : unsigned(39 downto 0) := (others => '0');
    signal sincos_row_3 : unsigned(39 downto 0) := (others => '0');
    signal sincos_row_4 : unsigned(39 downto 0) := (others => '0');
    signal sincos_row_5 : unsigned(39 downto 0) := (others => '0');
    signal sincos_row_6 : unsigned(39 downto 0) := (others => '0');
    signal setup_phi_p_s1 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal sincos_row_7 : unsigned(39 downto 0) := (others => '0');
    signal valid_s1 : std_logic;
    -- stage 1
    signal setup_frame_sincos_n10 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_frame_sincos_n11 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_frame_sincos_n13 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_frame_sincos_n14 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_light_sincos_n24 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_light_sincos_n25 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_light_sincos_n27 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_light_sincos_n28 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_half_sincos_n116 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_half_sincos_n117 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_half_sincos_n119 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_half_sincos_n120 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n215 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n216 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_frame_sincos_n10_s2 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_frame_sincos_n11_s2 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_frame_sincos_n13_s2 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_frame_sincos_n14_s2 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_light_sincos_n24_s2 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_light_sincos_n25_s2 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_light_sincos_n27_s2 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_light_sincos_n28_s2 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_half_sincos_n116_s2 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_half_sincos_n117_s2 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_half_sincos_n119_s2 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_half_sincos_n120_s2 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_phi_p_s2 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal dot_l_sincos_n215_s2 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n216_s2 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal valid_s2 : std_logic;
    -- stage 2
    signal setup_frame_n15 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_frame_n17 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_frame_n19 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_frame_n21 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_light_n29 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_light_n31 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_light_n35 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_light_n40 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_half_n121 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_half_n123 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_half_n127 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_half_n132 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_frame_sincos_n10_s3 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_frame_sincos_n11_s3 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_frame_n15_s3 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_frame_n17_s3 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_frame_n19_s3 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_frame_n21_s3 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_light_n29_s3 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_light_n31_s3 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_light_n35_s3 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_light_n40_s3 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_half_n121_s3 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_half_n123_s3 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_half_n127_s3 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_half_n132_s3 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_phi_p_s3 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal dot_l_sincos_n215_s3 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n216_s3 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal valid_s3 : std_logic;
    -- stage 3
    signal setup_frame_t_x_sum : signed(40 downto 0) := (others => '0');
    signal setup_frame_t_x_cut : signed(22 downto 0) := (others => '0');
    signal setup_frame_t_x_over : unsigned(0 downto 0) := (others => '0');
    signal setup_frame_t_x_under : unsigned(0 downto 0) := (others => '0');
    signal setup_frame_t_x : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_frame_t_y_sum : signed(40 downto 0) := (others => '0');
    signal setup_frame_t_y_cut : signed(22 downto 0) := (others => '0');
    signal setup_frame_t_y_over : unsigned(0 downto 0) := (others => '0');
    signal setup_frame_t_y_under : unsigned(0 downto 0) := (others => '0');
    signal setup_frame_t_y : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_frame_n_x_sum : signed(40 downto 0) := (others => '0');
    signal setup_frame_n_x_cut : signed(22 downto 0) := (others => '0');
    signal setup_frame_n_x_over : unsigned(0 downto 0) := (others => '0');
    signal setup_frame_n_x_under : unsigned(0 downto 0) := (others => '0');
    signal setup_frame_n_x : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_frame_n_y_sum : signed(40 downto 0) := (others => '0');
    signal setup_frame_n_y_cut : signed(22 downto 0) := (others => '0');
    signal setup_frame_n_y_over : unsigned(0 downto 0) := (others => '0');
    signal setup_frame_n_y_under : unsigned(0 downto 0) := (others => '0');
    signal setup_frame_n_y : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_light_world_x_sum : signed(40 downto 0) := (others => '0');
    signal setup_light_world_x_cut : signed(22 downto 0) := (others => '0');
    signal setup_light_world_x_over : unsigned(0 downto 0) := (others => '0');
    signal setup_light_world_x_under : unsigned(0 downto 0) := (others => '0');
    signal setup_light_world_x : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_light_world_y_sum : signed(40 downto 0) := (others => '0');
    signal setup_light_world_y_cut : signed(22 downto 0) := (others => '0');
    signal setup_light_world_y_over : unsigned(0 downto 0) := (others => '0');
    signal setup_light_world_y_under : unsigned(0 downto 0) := (others => '0');
    signal setup_light_world_y : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_half_world_x_sum : signed(40 downto 0) := (others => '0');
    signal setup_half_world_x_cut : signed(22 downto 0) := (others => '0');
    signal setup_half_world_x_over : unsigned(0 downto 0) := (others => '0');
    signal setup_half_world_x_under : unsigned(0 downto 0) := (others => '0');
    signal setup_half_world_x : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_half_world_y_sum : signed(40 downto 0) := (others => '0');
    signal setup_half_world_y_cut : signed(22 downto 0) := (others => '0');
    signal setup_half_world_y_over : unsigned(0 downto 0) := (others => '0');
    signal setup_half_world_y_under : unsigned(0 downto 0) := (others => '0');
    signal setup_half_world_y : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_frame_sincos_n10_s4 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_frame_sincos_n11_s4 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_frame_t_x_s4 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_frame_t_y_s4 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_frame_n_x_s4 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_frame_n_y_s4 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_light_world_x_s4 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_light_world_y_s4 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_light_n35_s4 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_light_n40_s4 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_half_world_x_s4 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_half_world_y_s4 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_half_n127_s4 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_half_n132_s4 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_phi_p_s4 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal dot_l_sincos_n215_s4 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n216_s4 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal valid_s4 : std_logic;
    -- stage 4
    signal setup_light_n33 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_light_n34 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_light_n36 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_light_n37 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_light_n38 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_light_n39 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_half_n125 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_half_n126 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_half_n128 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_half_n129 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_half_n130 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_half_n131 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_light_n33_s5 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_light_n34_s5 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_light_n35_s5 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_light_n36_s5 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_light_n37_s5 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_light_n38_s5 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_light_n39_s5 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_light_n40_s5 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_half_n125_s5 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_half_n126_s5 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_half_n127_s5 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_half_n128_s5 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_half_n129_s5 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_half_n130_s5 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_half_n131_s5 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_half_n132_s5 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal setup_phi_p_s5 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal dot_l_sincos_n215_s5 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n216_s5 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal valid_s5 : std_logic;
    -- stage 5
    signal setup_light_n41 : signed(40 downto 0) := (others => '0'); -- s41f36
    signal setup_light_n42 : signed(41 downto 0) := (others => '0'); -- s42f36
    signal setup_light_n43 : signed(40 downto 0) := (others => '0'); -- s41f36
    signal setup_light_n44 : signed(40 downto 0) := (others => '0'); -- s41f36
    signal setup_light_n45 : signed(41 downto 0) := (others => '0'); -- s42f36
    signal setup_light_y_sum : signed(41 downto 0) := (others => '0');
    signal setup_light_y_cut : signed(23 downto 0) := (others => '0');
    signal setup_light_y_over : unsigned(0 downto 0) := (others => '0');
    signal setup_light_y_under : unsigned(0 downto 0) := (others => '0');
    signal setup_light_y : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_light_azimuth_n50_neg : unsigned(19 downto 0) := (others => '0');
    signal setup_light_azimuth_n50 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_azimuth_n76 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_n133 : signed(40 downto 0) := (others => '0'); -- s41f36
    signal setup_half_n134 : signed(41 downto 0) := (others => '0'); -- s42f36
    signal setup_half_n135 : signed(40 downto 0) := (others => '0'); -- s41f36
    signal setup_half_n136 : signed(40 downto 0) := (others => '0'); -- s41f36
    signal setup_half_n137 : signed(41 downto 0) := (others => '0'); -- s42f36
    signal setup_half_y_sum : signed(41 downto 0) := (others => '0');
    signal setup_half_y_cut : signed(23 downto 0) := (others => '0');
    signal setup_half_y_over : unsigned(0 downto 0) := (others => '0');
    signal setup_half_y_under : unsigned(0 downto 0) := (others => '0');
    signal setup_half_y : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_half_azimuth_n142_neg : unsigned(19 downto 0) := (others => '0');
    signal setup_half_azimuth_n142 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_azimuth_n166 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_n42_s6 : signed(41 downto 0) := (others => '0'); -- s42f36
    signal setup_light_n45_s6 : signed(41 downto 0) := (others => '0'); -- s42f36
    signal setup_light_azimuth_n50_s6 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_azimuth_n76_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_n134_s6 : signed(41 downto 0) := (others => '0'); -- s42f36
    signal setup_half_n137_s6 : signed(41 downto 0) := (others => '0'); -- s42f36
    signal setup_half_azimuth_n142_s6 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_azimuth_n166_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_phi_p_s6 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal dot_l_sincos_n215_s6 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n216_s6 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal valid_s6 : std_logic;
    -- stage 6
    signal setup_light_x_sum : signed(42 downto 0) := (others => '0');
    signal setup_light_x_cut : signed(24 downto 0) := (others => '0');
    signal setup_light_x_over : unsigned(0 downto 0) := (others => '0');
    signal setup_light_x_under : unsigned(0 downto 0) := (others => '0');
    signal setup_light_x : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_light_z_sum : signed(42 downto 0) := (others => '0');
    signal setup_light_z_cut : signed(24 downto 0) := (others => '0');
    signal setup_light_z_over : unsigned(0 downto 0) := (others => '0');
    signal setup_light_z_under : unsigned(0 downto 0) := (others => '0');
    signal setup_light_z : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_light_azimuth_n49_neg : unsigned(19 downto 0) := (others => '0');
    signal setup_light_azimuth_n49 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_azimuth_n51 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_azimuth_n52 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_azimuth_n53 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_azimuth_n72 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_polar_angle_n83_neg : unsigned(19 downto 0) := (others => '0');
    signal setup_light_polar_angle_n83 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_polar_angle_n104 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_x_sum : signed(42 downto 0) := (others => '0');
    signal setup_half_x_cut : signed(24 downto 0) := (others => '0');
    signal setup_half_x_over : unsigned(0 downto 0) := (others => '0');
    signal setup_half_x_under : unsigned(0 downto 0) := (others => '0');
    signal setup_half_x : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_half_z_sum : signed(42 downto 0) := (others => '0');
    signal setup_half_z_cut : signed(24 downto 0) := (others => '0');
    signal setup_half_z_over : unsigned(0 downto 0) := (others => '0');
    signal setup_half_z_under : unsigned(0 downto 0) := (others => '0');
    signal setup_half_z : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_half_azimuth_n141_neg : unsigned(19 downto 0) := (others => '0');
    signal setup_half_azimuth_n141 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_azimuth_n143 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_azimuth_n144 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_azimuth_n145 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_azimuth_n163 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_polar_angle_n173_neg : unsigned(19 downto 0) := (others => '0');
    signal setup_half_polar_angle_n173 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_polar_angle_n194 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_azimuth_n51_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_azimuth_n52_s7 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_azimuth_n53_s7 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_azimuth_n72_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_azimuth_n76_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_polar_angle_n83_s7 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_polar_angle_n104_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_azimuth_n143_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_azimuth_n144_s7 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_azimuth_n145_s7 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_azimuth_n163_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_azimuth_n166_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_polar_angle_n173_s7 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_polar_angle_n194_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_phi_p_s7 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal dot_l_sincos_n215_s7 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n216_s7 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal valid_s7 : std_logic;
    -- stage 7
    signal setup_light_azimuth_n54_padded : unsigned(31 downto 0) := (others => '0');
    signal setup_light_azimuth_n54_skip16 : unsigned(0 downto 0) := (others => '0');
    signal setup_light_azimuth_n54_part16 : unsigned(15 downto 0) := (others => '0');
    signal setup_light_azimuth_n54_skip8 : unsigned(0 downto 0) := (others => '0');
    signal setup_light_azimuth_n54_part8 : unsigned(7 downto 0) := (others => '0');
    signal setup_light_azimuth_n54_skip4 : unsigned(0 downto 0) := (others => '0');
    signal setup_light_azimuth_n54_part4 : unsigned(3 downto 0) := (others => '0');
    signal setup_light_azimuth_n54_skip2 : unsigned(0 downto 0) := (others => '0');
    signal setup_light_azimuth_n54_part2 : unsigned(1 downto 0) := (others => '0');
    signal setup_light_azimuth_n54_skip1 : unsigned(0 downto 0) := (others => '0');
    signal setup_light_azimuth_n54 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_light_azimuth_n55_past : unsigned(0 downto 0) := (others => '0');
    signal setup_light_azimuth_n55_count : unsigned(4 downto 0) := (others => '0');
    signal setup_light_azimuth_n55 : unsigned(39 downto 0) := (others => '0'); -- u40f18
    signal setup_light_azimuth_n56 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_light_azimuth_n57_past : unsigned(0 downto 0) := (others => '0');
    signal setup_light_azimuth_n57_count : unsigned(4 downto 0) := (others => '0');
    signal setup_light_azimuth_n57 : unsigned(39 downto 0) := (others => '0'); -- u40f18
    signal setup_light_azimuth_n58 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_light_azimuth_n59 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_light_azimuth_n60 : unsigned(18 downto 0) := (others => '0'); -- u19f20
    signal setup_light_azimuth_recip_n61 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_light_azimuth_n63 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal setup_half_azimuth_n146_padded : unsigned(31 downto 0) := (others => '0');
    signal setup_half_azimuth_n146_skip16 : unsigned(0 downto 0) := (others => '0');
    signal setup_half_azimuth_n146_part16 : unsigned(15 downto 0) := (others => '0');
    signal setup_half_azimuth_n146_skip8 : unsigned(0 downto 0) := (others => '0');
    signal setup_half_azimuth_n146_part8 : unsigned(7 downto 0) := (others => '0');
    signal setup_half_azimuth_n146_skip4 : unsigned(0 downto 0) := (others => '0');
    signal setup_half_azimuth_n146_part4 : unsigned(3 downto 0) := (others => '0');
    signal setup_half_azimuth_n146_skip2 : unsigned(0 downto 0) := (others => '0');
    signal setup_half_azimuth_n146_part2 : unsigned(1 downto 0) := (others => '0');
    signal setup_half_azimuth_n146_skip1 : unsigned(0 downto 0) := (others => '0');
    signal setup_half_azimuth_n146 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_half_azimuth_n147_past : unsigned(0 downto 0) := (others => '0');
    signal setup_half_azimuth_n147_count : unsigned(4 downto 0) := (others => '0');
    signal setup_half_azimuth_n147 : unsigned(39 downto 0) := (others => '0'); -- u40f18
    signal setup_half_azimuth_n148 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_half_azimuth_n149_past : unsigned(0 downto 0) := (others => '0');
    signal setup_half_azimuth_n149_count : unsigned(4 downto 0) := (others => '0');
    signal setup_half_azimuth_n149 : unsigned(39 downto 0) := (others => '0'); -- u40f18
    signal setup_half_azimuth_n150 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_half_azimuth_n151 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_half_azimuth_n152 : unsigned(18 downto 0) := (others => '0'); -- u19f20
    signal setup_half_azimuth_recip_n153 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_half_azimuth_n155 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal setup_light_azimuth_n51_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_azimuth_n52_s8 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_azimuth_recip_n61_s8 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_light_azimuth_n63_s8 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal setup_light_azimuth_n72_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_azimuth_n76_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_polar_angle_n83_s8 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_polar_angle_n104_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_azimuth_n143_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_azimuth_n144_s8 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_azimuth_recip_n153_s8 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_half_azimuth_n155_s8 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal setup_half_azimuth_n163_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_azimuth_n166_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_polar_angle_n173_s8 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_polar_angle_n194_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_phi_p_s8 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal dot_l_sincos_n215_s8 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n216_s8 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal valid_s8 : std_logic;
    -- stage 8
    signal setup_light_azimuth_n51_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_azimuth_n52_s9 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal recip_row : unsigned(19 downto 0) := (others => '0');
    signal setup_light_azimuth_n63_s9 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal setup_light_azimuth_n72_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_azimuth_n76_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_polar_angle_n83_s9 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_polar_angle_n104_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_azimuth_n143_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_azimuth_n144_s9 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal recip_row_2 : unsigned(19 downto 0) := (others => '0');
    signal setup_half_azimuth_n155_s9 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal setup_half_azimuth_n163_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_azimuth_n166_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_polar_angle_n173_s9 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_polar_angle_n194_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_phi_p_s9 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal dot_l_sincos_n215_s9 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n216_s9 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal valid_s9 : std_logic;
    -- stage 9
    signal setup_light_azimuth_recip_n62 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_azimuth_recip_n154 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_azimuth_n51_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_azimuth_n52_s10 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_azimuth_recip_n62_s10 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_azimuth_n63_s10 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal setup_light_azimuth_n72_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_azimuth_n76_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_polar_angle_n83_s10 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_polar_angle_n104_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_azimuth_n143_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_azimuth_n144_s10 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_azimuth_recip_n154_s10 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_azimuth_n155_s10 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal setup_half_azimuth_n163_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_azimuth_n166_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_polar_angle_n173_s10 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_polar_angle_n194_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_phi_p_s10 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal dot_l_sincos_n215_s10 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n216_s10 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal valid_s10 : std_logic;
    -- stage 10
    signal setup_light_azimuth_n64 : unsigned(39 downto 0) := (others => '0'); -- u40f38
    signal setup_half_azimuth_n156 : unsigned(39 downto 0) := (others => '0'); -- u40f38
    signal setup_light_azimuth_n51_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_azimuth_n52_s11 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_azimuth_n64_s11 : unsigned(39 downto 0) := (others => '0'); -- u40f38
    signal setup_light_azimuth_n72_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_azimuth_n76_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_polar_angle_n83_s11 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_polar_angle_n104_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_azimuth_n143_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_azimuth_n144_s11 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_azimuth_n156_s11 : unsigned(39 downto 0) := (others => '0'); -- u40f38
    signal setup_half_azimuth_n163_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_azimuth_n166_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_polar_angle_n173_s11 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_polar_angle_n194_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_phi_p_s11 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal dot_l_sincos_n215_s11 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n216_s11 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal valid_s11 : std_logic;
    -- stage 11
    signal setup_light_azimuth_ratio_sum : unsigned(40 downto 0) := (others => '0');
    signal setup_light_azimuth_ratio_cut : unsigned(20 downto 0) := (others => '0');
    signal setup_light_azimuth_ratio_over : unsigned(0 downto 0) := (others => '0');
    signal setup_light_azimuth_ratio : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal setup_light_azimuth_atan_n66 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_half_azimuth_ratio_sum : unsigned(40 downto 0) := (others => '0');
    signal setup_half_azimuth_ratio_cut : unsigned(20 downto 0) := (others => '0');
    signal setup_half_azimuth_ratio_over : unsigned(0 downto 0) := (others => '0');
    signal setup_half_azimuth_ratio : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal setup_half_azimuth_atan_n158 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_light_azimuth_n51_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_azimuth_n52_s12 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal atan_row : unsigned(37 downto 0) := (others => '0');
    signal setup_light_azimuth_n72_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_azimuth_n76_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_polar_angle_n83_s12 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_polar_angle_n104_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_azimuth_n143_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_azimuth_n144_s12 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal atan_row_2 : unsigned(37 downto 0) := (others => '0');
    signal setup_half_azimuth_n163_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_azimuth_n166_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_polar_angle_n173_s12 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_polar_angle_n194_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_phi_p_s12 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal dot_l_sincos_n215_s12 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n216_s12 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal valid_s12 : std_logic;
    -- stage 12
    signal setup_light_azimuth_atan_n67 : unsigned(18 downto 0) := (others => '0'); -- u19f18
    signal setup_light_azimuth_atan_n68 : unsigned(18 downto 0) := (others => '0'); -- u19f18
    signal setup_light_azimuth_n70 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_light_azimuth_n71 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_half_azimuth_atan_n159 : unsigned(18 downto 0) := (others => '0'); -- u19f18
    signal setup_half_azimuth_atan_n160 : unsigned(18 downto 0) := (others => '0'); -- u19f18
    signal setup_half_azimuth_n161 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_half_azimuth_n162 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_light_azimuth_n52_s13 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_azimuth_atan_n68_s13 : unsigned(18 downto 0) := (others => '0'); -- u19f18
    signal setup_light_azimuth_n71_s13 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_light_azimuth_n72_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_azimuth_n76_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_polar_angle_n83_s13 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_polar_angle_n104_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_azimuth_n144_s13 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_azimuth_atan_n160_s13 : unsigned(18 downto 0) := (others => '0'); -- u19f18
    signal setup_half_azimuth_n162_s13 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_half_azimuth_n163_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_azimuth_n166_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_polar_angle_n173_s13 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_polar_angle_n194_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_phi_p_s13 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal dot_l_sincos_n215_s13 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n216_s13 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal valid_s13 : std_logic;
    -- stage 13
    signal setup_light_azimuth_n74 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_light_azimuth_n75 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_light_azimuth_n77 : signed(21 downto 0) := (others => '0'); -- s22f18
    signal setup_light_azimuth_n78 : signed(21 downto 0) := (others => '0'); -- s22f18
    signal setup_light_azimuth_n79 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal setup_light_azimuth_n80 : unsigned(38 downto 0) := (others => '0'); -- u39f36
    signal setup_light_n111_sum : unsigned(18 downto 0) := (others => '0');
    signal setup_light_n111_cut : unsigned(16 downto 0) := (others => '0');
    signal setup_light_n111 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal setup_light_phi : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal setup_half_azimuth_n164 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_half_azimuth_n165 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_half_azimuth_n167 : signed(21 downto 0) := (others => '0'); -- s22f18
    signal setup_half_azimuth_n168 : signed(21 downto 0) := (others => '0'); -- s22f18
    signal setup_half_azimuth_n169 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal setup_half_azimuth_n170 : unsigned(38 downto 0) := (others => '0'); -- u39f36
    signal setup_half_n201_sum : unsigned(18 downto 0) := (others => '0');
    signal setup_half_n201_cut : unsigned(16 downto 0) := (others => '0');
    signal setup_half_n201 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal setup_half_phi : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal setup_light_azimuth_n80_s14 : unsigned(38 downto 0) := (others => '0'); -- u39f36
    signal setup_light_polar_angle_n83_s14 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_polar_angle_n104_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_phi_s14 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal setup_half_azimuth_n170_s14 : unsigned(38 downto 0) := (others => '0'); -- u39f36
    signal setup_half_polar_angle_n173_s14 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_polar_angle_n194_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_phi_s14 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal setup_phi_p_s14 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal dot_l_sincos_n215_s14 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n216_s14 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal valid_s14 : std_logic;
    -- stage 14
    signal setup_light_azimuth_n81_sum : unsigned(39 downto 0) := (others => '0');
    signal setup_light_azimuth_n81_cut : unsigned(21 downto 0) := (others => '0');
    signal setup_light_azimuth_n81_over : unsigned(0 downto 0) := (others => '0');
    signal setup_light_azimuth_n81 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_light_n82_over : unsigned(0 downto 0) := (others => '0');
    signal setup_light_n82_under : unsigned(0 downto 0) := (others => '0');
    signal setup_light_n82 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_light_polar_angle_n84_neg : unsigned(19 downto 0) := (others => '0');
    signal setup_light_polar_angle_n84 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_polar_angle_n107 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_azimuth_n171_sum : unsigned(39 downto 0) := (others => '0');
    signal setup_half_azimuth_n171_cut : unsigned(21 downto 0) := (others => '0');
    signal setup_half_azimuth_n171_over : unsigned(0 downto 0) := (others => '0');
    signal setup_half_azimuth_n171 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_half_n172_over : unsigned(0 downto 0) := (others => '0');
    signal setup_half_n172_under : unsigned(0 downto 0) := (others => '0');
    signal setup_half_n172 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_half_polar_angle_n174_neg : unsigned(19 downto 0) := (others => '0');
    signal setup_half_polar_angle_n174 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_polar_angle_n197 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal dot_l_n207 : signed(16 downto 0) := (others => '0'); -- s17f16
    signal dot_l_delta : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal dot_l_sincos_n209 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal dot_h_n223 : signed(16 downto 0) := (others => '0'); -- s17f16
    signal dot_h_delta : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal dot_h_sincos_n225 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_light_polar_angle_n83_s15 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_polar_angle_n84_s15 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_polar_angle_n104_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_polar_angle_n107_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_polar_angle_n173_s15 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_polar_angle_n174_s15 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_polar_angle_n194_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_polar_angle_n197_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal sincos_row_8 : unsigned(39 downto 0) := (others => '0');
    signal dot_l_sincos_n215_s15 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n216_s15 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal sincos_row_9 : unsigned(39 downto 0) := (others => '0');
    signal valid_s15 : std_logic;
    -- stage 15
    signal setup_light_polar_angle_n85 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_polar_angle_n86 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_polar_angle_n87 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_polar_angle_n88_padded : unsigned(31 downto 0) := (others => '0');
    signal setup_light_polar_angle_n88_skip16 : unsigned(0 downto 0) := (others => '0');
    signal setup_light_polar_angle_n88_part16 : unsigned(15 downto 0) := (others => '0');
    signal setup_light_polar_angle_n88_skip8 : unsigned(0 downto 0) := (others => '0');
    signal setup_light_polar_angle_n88_part8 : unsigned(7 downto 0) := (others => '0');
    signal setup_light_polar_angle_n88_skip4 : unsigned(0 downto 0) := (others => '0');
    signal setup_light_polar_angle_n88_part4 : unsigned(3 downto 0) := (others => '0');
    signal setup_light_polar_angle_n88_skip2 : unsigned(0 downto 0) := (others => '0');
    signal setup_light_polar_angle_n88_part2 : unsigned(1 downto 0) := (others => '0');
    signal setup_light_polar_angle_n88_skip1 : unsigned(0 downto 0) := (others => '0');
    signal setup_light_polar_angle_n88 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_half_polar_angle_n175 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_polar_angle_n176 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_polar_angle_n177 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_polar_angle_n178_padded : unsigned(31 downto 0) := (others => '0');
    signal setup_half_polar_angle_n178_skip16 : unsigned(0 downto 0) := (others => '0');
    signal setup_half_polar_angle_n178_part16 : unsigned(15 downto 0) := (others => '0');
    signal setup_half_polar_angle_n178_skip8 : unsigned(0 downto 0) := (others => '0');
    signal setup_half_polar_angle_n178_part8 : unsigned(7 downto 0) := (others => '0');
    signal setup_half_polar_angle_n178_skip4 : unsigned(0 downto 0) := (others => '0');
    signal setup_half_polar_angle_n178_part4 : unsigned(3 downto 0) := (others => '0');
    signal setup_half_polar_angle_n178_skip2 : unsigned(0 downto 0) := (others => '0');
    signal setup_half_polar_angle_n178_part2 : unsigned(1 downto 0) := (others => '0');
    signal setup_half_polar_angle_n178_skip1 : unsigned(0 downto 0) := (others => '0');
    signal setup_half_polar_angle_n178 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal dot_l_sincos_n210 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_h_sincos_n226 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_light_polar_angle_n85_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_polar_angle_n86_s16 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_polar_angle_n87_s16 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_polar_angle_n88_s16 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_light_polar_angle_n104_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_polar_angle_n107_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_polar_angle_n175_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_polar_angle_n176_s16 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_polar_angle_n177_s16 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_polar_angle_n178_s16 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_half_polar_angle_n194_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_polar_angle_n197_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal dot_l_sincos_n210_s16 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n215_s16 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n216_s16 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_h_sincos_n226_s16 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal valid_s16 : std_logic;
    -- stage 16
    signal setup_light_polar_angle_n89_past : unsigned(0 downto 0) := (others => '0');
    signal setup_light_polar_angle_n89_count : unsigned(4 downto 0) := (others => '0');
    signal setup_light_polar_angle_n89 : unsigned(39 downto 0) := (others => '0'); -- u40f18
    signal setup_light_polar_angle_n90 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_light_polar_angle_n91_past : unsigned(0 downto 0) := (others => '0');
    signal setup_light_polar_angle_n91_count : unsigned(4 downto 0) := (others => '0');
    signal setup_light_polar_angle_n91 : unsigned(39 downto 0) := (others => '0'); -- u40f18
    signal setup_light_polar_angle_n92 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_light_polar_angle_n93 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_light_polar_angle_n94 : unsigned(18 downto 0) := (others => '0'); -- u19f20
    signal setup_light_polar_angle_recip_n95 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_light_polar_angle_n97 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal setup_half_polar_angle_n179_past : unsigned(0 downto 0) := (others => '0');
    signal setup_half_polar_angle_n179_count : unsigned(4 downto 0) := (others => '0');
    signal setup_half_polar_angle_n179 : unsigned(39 downto 0) := (others => '0'); -- u40f18
    signal setup_half_polar_angle_n180 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_half_polar_angle_n181_past : unsigned(0 downto 0) := (others => '0');
    signal setup_half_polar_angle_n181_count : unsigned(4 downto 0) := (others => '0');
    signal setup_half_polar_angle_n181 : unsigned(39 downto 0) := (others => '0'); -- u40f18
    signal setup_half_polar_angle_n182 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_half_polar_angle_n183 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_half_polar_angle_n184 : unsigned(18 downto 0) := (others => '0'); -- u19f20
    signal setup_half_polar_angle_recip_n185 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_half_polar_angle_n187 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal setup_light_polar_angle_n85_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal recip_row_3 : unsigned(19 downto 0) := (others => '0');
    signal setup_light_polar_angle_n97_s17 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal setup_light_polar_angle_n104_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_polar_angle_n107_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_polar_angle_n175_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal recip_row_4 : unsigned(19 downto 0) := (others => '0');
    signal setup_half_polar_angle_n187_s17 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal setup_half_polar_angle_n194_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_polar_angle_n197_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal dot_l_sincos_n210_s17 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n215_s17 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n216_s17 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_h_sincos_n226_s17 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal valid_s17 : std_logic;
    -- stage 17
    signal setup_light_polar_angle_recip_n96 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_polar_angle_recip_n186 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_polar_angle_n85_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_polar_angle_recip_n96_s18 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_polar_angle_n97_s18 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal setup_light_polar_angle_n104_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_polar_angle_n107_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_polar_angle_n175_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_polar_angle_recip_n186_s18 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_polar_angle_n187_s18 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal setup_half_polar_angle_n194_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_polar_angle_n197_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal dot_l_sincos_n210_s18 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n215_s18 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n216_s18 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_h_sincos_n226_s18 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal valid_s18 : std_logic;
    -- stage 18
    signal setup_light_polar_angle_n98 : unsigned(39 downto 0) := (others => '0'); -- u40f38
    signal setup_half_polar_angle_n188 : unsigned(39 downto 0) := (others => '0'); -- u40f38
    signal setup_light_polar_angle_n85_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_polar_angle_n98_s19 : unsigned(39 downto 0) := (others => '0'); -- u40f38
    signal setup_light_polar_angle_n104_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_polar_angle_n107_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_polar_angle_n175_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_polar_angle_n188_s19 : unsigned(39 downto 0) := (others => '0'); -- u40f38
    signal setup_half_polar_angle_n194_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_polar_angle_n197_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal dot_l_sincos_n210_s19 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n215_s19 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n216_s19 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_h_sincos_n226_s19 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal valid_s19 : std_logic;
    -- stage 19
    signal setup_light_polar_angle_ratio_sum : unsigned(40 downto 0) := (others => '0');
    signal setup_light_polar_angle_ratio_cut : unsigned(20 downto 0) := (others => '0');
    signal setup_light_polar_angle_ratio_over : unsigned(0 downto 0) := (others => '0');
    signal setup_light_polar_angle_ratio : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal setup_light_polar_angle_atan_n100 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_half_polar_angle_ratio_sum : unsigned(40 downto 0) := (others => '0');
    signal setup_half_polar_angle_ratio_cut : unsigned(20 downto 0) := (others => '0');
    signal setup_half_polar_angle_ratio_over : unsigned(0 downto 0) := (others => '0');
    signal setup_half_polar_angle_ratio : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal setup_half_polar_angle_atan_n190 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_light_polar_angle_n85_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal atan_row_3 : unsigned(37 downto 0) := (others => '0');
    signal setup_light_polar_angle_n104_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_polar_angle_n107_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_polar_angle_n175_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal atan_row_4 : unsigned(37 downto 0) := (others => '0');
    signal setup_half_polar_angle_n194_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_polar_angle_n197_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal dot_l_sincos_n210_s20 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n215_s20 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n216_s20 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_h_sincos_n226_s20 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal valid_s20 : std_logic;
    -- stage 20
    signal setup_light_polar_angle_atan_n101 : unsigned(18 downto 0) := (others => '0'); -- u19f18
    signal setup_light_polar_angle_n102 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_light_polar_angle_n103 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_half_polar_angle_atan_n191 : unsigned(18 downto 0) := (others => '0'); -- u19f18
    signal setup_half_polar_angle_n192 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_half_polar_angle_n193 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_light_polar_angle_n103_s21 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_light_polar_angle_n104_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_polar_angle_n107_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_polar_angle_n193_s21 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_half_polar_angle_n194_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_polar_angle_n197_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal dot_l_sincos_n210_s21 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n215_s21 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n216_s21 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_h_sincos_n226_s21 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal valid_s21 : std_logic;
    -- stage 21
    signal setup_light_polar_angle_n105 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_light_polar_angle_n106 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_light_polar_angle_n108 : signed(21 downto 0) := (others => '0'); -- s22f18
    signal setup_light_polar_angle_n109 : signed(21 downto 0) := (others => '0'); -- s22f18
    signal setup_light_polar_angle_n110 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal setup_light_n113_sum : unsigned(18 downto 0) := (others => '0');
    signal setup_light_n113_cut : unsigned(16 downto 0) := (others => '0');
    signal setup_light_n113 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal setup_light_theta : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal setup_half_polar_angle_n195 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_half_polar_angle_n196 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_half_polar_angle_n198 : signed(21 downto 0) := (others => '0'); -- s22f18
    signal setup_half_polar_angle_n199 : signed(21 downto 0) := (others => '0'); -- s22f18
    signal setup_half_polar_angle_n200 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal setup_half_n203_sum : unsigned(18 downto 0) := (others => '0');
    signal setup_half_n203_cut : unsigned(16 downto 0) := (others => '0');
    signal setup_half_n203 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal setup_half_theta : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal dot_l_sincos_n211 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal dot_h_sincos_n227 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal dot_l_sincos_n210_s22 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n211_s22 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal dot_l_sincos_n215_s22 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n216_s22 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_h_sincos_n226_s22 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_h_sincos_n227_s22 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal valid_s22 : std_logic;
    -- stage 22
    signal dot_l_sincos_n210_s23 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal sincos_row_10 : unsigned(39 downto 0) := (others => '0');
    signal dot_l_sincos_n215_s23 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n216_s23 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_h_sincos_n226_s23 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal sincos_row_11 : unsigned(39 downto 0) := (others => '0');
    signal valid_s23 : std_logic;
    -- stage 23
    signal dot_l_sincos_n212 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n213 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_h_sincos_n228 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_h_sincos_n229 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n210_s24 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n212_s24 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n213_s24 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n215_s24 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_sincos_n216_s24 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_h_sincos_n226_s24 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_h_sincos_n228_s24 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_h_sincos_n229_s24 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal valid_s24 : std_logic;
    -- stage 24
    signal dot_l_n217 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal dot_l_n218 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal dot_h_n230 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal dot_h_n231 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal dot_l_sincos_n210_s25 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_n217_s25 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal dot_l_n218_s25 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal dot_h_sincos_n226_s25 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_h_n230_s25 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal dot_h_n231_s25 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal valid_s25 : std_logic;
    -- stage 25
    signal dot_l_n219_sum : signed(40 downto 0) := (others => '0');
    signal dot_l_n219_cut : signed(22 downto 0) := (others => '0');
    signal dot_l_n219_over : unsigned(0 downto 0) := (others => '0');
    signal dot_l_n219_under : unsigned(0 downto 0) := (others => '0');
    signal dot_l_n219 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal dot_h_n232_sum : signed(40 downto 0) := (others => '0');
    signal dot_h_n232_cut : signed(22 downto 0) := (others => '0');
    signal dot_h_n232_over : unsigned(0 downto 0) := (others => '0');
    signal dot_h_n232_under : unsigned(0 downto 0) := (others => '0');
    signal dot_h_n232 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal dot_l_sincos_n210_s26 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_n217_s26 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal dot_l_n219_s26 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal dot_h_sincos_n226_s26 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_h_n230_s26 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal dot_h_n232_s26 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal valid_s26 : std_logic;
    -- stage 26
    signal dot_l_n220 : signed(40 downto 0) := (others => '0'); -- s41f36
    signal dot_h_n233 : signed(40 downto 0) := (others => '0'); -- s41f36
    signal dot_l_n217_s27 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal dot_l_n220_s27 : signed(40 downto 0) := (others => '0'); -- s41f36
    signal dot_h_n230_s27 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal dot_h_n233_s27 : signed(40 downto 0) := (others => '0'); -- s41f36
    signal valid_s27 : std_logic;
    -- stage 27
    signal dot_l_n221 : signed(41 downto 0) := (others => '0'); -- s42f36
    signal dot_l_sum : signed(42 downto 0) := (others => '0');
    signal dot_l_cut : signed(22 downto 0) := (others => '0');
    signal dot_l_over : unsigned(0 downto 0) := (others => '0');
    signal dot_l_under : unsigned(0 downto 0) := (others => '0');
    signal dot_l : signed(17 downto 0) := (others => '0'); -- s18f16
    signal dot_h_n234 : signed(41 downto 0) := (others => '0'); -- s42f36
    signal dot_h_sum : signed(42 downto 0) := (others => '0');
    signal dot_h_cut : signed(22 downto 0) := (others => '0');
    signal dot_h_over : unsigned(0 downto 0) := (others => '0');
    signal dot_h_under : unsigned(0 downto 0) := (others => '0');
    signal dot_h : signed(17 downto 0) := (others => '0'); -- s18f16
    signal n237 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n238 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal diffuse_index_under : unsigned(0 downto 0) := (others => '0');
    signal diffuse_index : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal n240 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n241 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal n242 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal diffuse_n243 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal n249 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n250 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal specular_index_under : unsigned(0 downto 0) := (others => '0');
    signal specular_index : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal n252 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n253 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal n254 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal specular_n255 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal n237_s28 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n240_s28 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal diffuse_n243_s28 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal n249_s28 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n252_s28 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal specular_n255_s28 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal valid_s28 : std_logic;
    -- stage 28
    signal n237_s29 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n240_s29 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal diffuse_row : unsigned(15 downto 0) := (others => '0');
    signal n249_s29 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n252_s29 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal specular_row : unsigned(15 downto 0) := (others => '0');
    signal valid_s29 : std_logic;
    -- stage 29
    signal diffuse_n244 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal n247 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal diffuse_next : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal specular_n256 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal n259 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal specular_next : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal n261 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal intensity_next_over : unsigned(0 downto 0) := (others => '0');
    signal intensity_next : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s30 : std_logic;
begin

    -- ---- stage 0 ----
    -- setup.frame.sincos
    setup_frame_sincos_n9 <= phi_n(15 downto 6);
    setup_frame_sincos_n12 <= theta_n(15 downto 6);
    -- setup.light.sincos
    setup_light_sincos_n23 <= phi_l(15 downto 6);
    setup_light_sincos_n26 <= theta_l(15 downto 6);
    -- setup.light.azimuth
    setup_light_azimuth_n69 <= 19x"10000";
    setup_light_azimuth_n73 <= 19x"20000";
    -- setup.half.sincos
    setup_half_sincos_n115 <= phi_h(15 downto 6);
    setup_half_sincos_n118 <= theta_h(15 downto 6);
    -- setup
    setup_n205 <= resize(phi_p, 17) + resize(psi, 17);
    setup_phi_p <= setup_n205(15 downto 0);
    -- dot_l.sincos
    dot_l_sincos_n214 <= theta_p(15 downto 6);
    -- (unit)
    n236 <= "0";
    n245 <= 16x"b333";
    n246 <= 16x"199a";
    n257 <= 16x"4ccd";
    n258 <= 16x"0000";

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                sincos_row <= sincos_rom(to_integer(setup_frame_sincos_n9));
                sincos_row_2 <= sincos_rom(to_integer(setup_frame_sincos_n12));
                sincos_row_3 <= sincos_rom_2(to_integer(setup_light_sincos_n23));
                sincos_row_4 <= sincos_rom_2(to_integer(setup_light_sincos_n26));
                sincos_row_5 <= sincos_rom_3(to_integer(setup_half_sincos_n115));
                sincos_row_6 <= sincos_rom_3(to_integer(setup_half_sincos_n118));
                setup_phi_p_s1 <= setup_phi_p;
                sincos_row_7 <= sincos_rom_4(to_integer(dot_l_sincos_n214));
            end if;
            if rst = '1' then
                valid_s1 <= '0';
            elsif ce = '1' then
                valid_s1 <= valid_in;
            end if;
        end if;
    end process;

    -- ---- stage 1 ----
    -- setup.frame.sincos
    setup_frame_sincos_n10 <= signed(sincos_row(39 downto 20));
    setup_frame_sincos_n11 <= signed(sincos_row(19 downto 0));
    setup_frame_sincos_n13 <= signed(sincos_row_2(39 downto 20));
    setup_frame_sincos_n14 <= signed(sincos_row_2(19 downto 0));
    -- setup.light.sincos
    setup_light_sincos_n24 <= signed(sincos_row_3(39 downto 20));
    setup_light_sincos_n25 <= signed(sincos_row_3(19 downto 0));
    setup_light_sincos_n27 <= signed(sincos_row_4(39 downto 20));
    setup_light_sincos_n28 <= signed(sincos_row_4(19 downto 0));
    -- setup.half.sincos
    setup_half_sincos_n116 <= signed(sincos_row_5(39 downto 20));
    setup_half_sincos_n117 <= signed(sincos_row_5(19 downto 0));
    setup_half_sincos_n119 <= signed(sincos_row_6(39 downto 20));
    setup_half_sincos_n120 <= signed(sincos_row_6(19 downto 0));
    -- dot_l.sincos
    dot_l_sincos_n215 <= signed(sincos_row_7(39 downto 20));
    dot_l_sincos_n216 <= signed(sincos_row_7(19 downto 0));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_frame_sincos_n10_s2 <= setup_frame_sincos_n10;
                setup_frame_sincos_n11_s2 <= setup_frame_sincos_n11;
                setup_frame_sincos_n13_s2 <= setup_frame_sincos_n13;
                setup_frame_sincos_n14_s2 <= setup_frame_sincos_n14;
                setup_light_sincos_n24_s2 <= setup_light_sincos_n24;
                setup_light_sincos_n25_s2 <= setup_light_sincos_n25;
                setup_light_sincos_n27_s2 <= setup_light_sincos_n27;
                setup_light_sincos_n28_s2 <= setup_light_sincos_n28;
                setup_half_sincos_n116_s2 <= setup_half_sincos_n116;
                setup_half_sincos_n117_s2 <= setup_half_sincos_n117;
                setup_half_sincos_n119_s2 <= setup_half_sincos_n119;
                setup_half_sincos_n120_s2 <= setup_half_sincos_n120;
                setup_phi_p_s2 <= setup_phi_p_s1;
                dot_l_sincos_n215_s2 <= dot_l_sincos_n215;
                dot_l_sincos_n216_s2 <= dot_l_sincos_n216;
            end if;
            if rst = '1' then
                valid_s2 <= '0';
            elsif ce = '1' then
                valid_s2 <= valid_s1;
            end if;
        end if;
    end process;

    -- ---- stage 2 ----
    -- setup.frame
    setup_frame_n15 <= setup_frame_sincos_n14_s2 * setup_frame_sincos_n11_s2;
    setup_frame_n17 <= setup_frame_sincos_n14_s2 * setup_frame_sincos_n10_s2;
    setup_frame_n19 <= setup_frame_sincos_n13_s2 * setup_frame_sincos_n11_s2;
    setup_frame_n21 <= setup_frame_sincos_n13_s2 * setup_frame_sincos_n10_s2;
    -- setup.light
    setup_light_n29 <= setup_light_sincos_n27_s2 * setup_light_sincos_n25_s2;
    setup_light_n31 <= setup_light_sincos_n27_s2 * setup_light_sincos_n24_s2;
    setup_light_n35 <= setup_frame_sincos_n13_s2 * setup_light_sincos_n28_s2;
    setup_light_n40 <= setup_frame_sincos_n14_s2 * setup_light_sincos_n28_s2;
    -- setup.half
    setup_half_n121 <= setup_half_sincos_n119_s2 * setup_half_sincos_n117_s2;
    setup_half_n123 <= setup_half_sincos_n119_s2 * setup_half_sincos_n116_s2;
    setup_half_n127 <= setup_frame_sincos_n13_s2 * setup_half_sincos_n120_s2;
    setup_half_n132 <= setup_frame_sincos_n14_s2 * setup_half_sincos_n120_s2;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_frame_sincos_n10_s3 <= setup_frame_sincos_n10_s2;
                setup_frame_sincos_n11_s3 <= setup_frame_sincos_n11_s2;
                setup_frame_n15_s3 <= setup_frame_n15;
                setup_frame_n17_s3 <= setup_frame_n17;
                setup_frame_n19_s3 <= setup_frame_n19;
                setup_frame_n21_s3 <= setup_frame_n21;
                setup_light_n29_s3 <= setup_light_n29;
                setup_light_n31_s3 <= setup_light_n31;
                setup_light_n35_s3 <= setup_light_n35;
                setup_light_n40_s3 <= setup_light_n40;
                setup_half_n121_s3 <= setup_half_n121;
                setup_half_n123_s3 <= setup_half_n123;
                setup_half_n127_s3 <= setup_half_n127;
                setup_half_n132_s3 <= setup_half_n132;
                setup_phi_p_s3 <= setup_phi_p_s2;
                dot_l_sincos_n215_s3 <= dot_l_sincos_n215_s2;
                dot_l_sincos_n216_s3 <= dot_l_sincos_n216_s2;
            end if;
            if rst = '1' then
                valid_s3 <= '0';
            elsif ce = '1' then
                valid_s3 <= valid_s2;
            end if;
        end if;
    end process;

    -- ---- stage 3 ----
    -- setup.frame
    setup_frame_t_x_sum <= resize(setup_frame_n15_s3, 41) + 41x"00000020000";
    setup_frame_t_x_cut <= setup_frame_t_x_sum(40 downto 18);
    setup_frame_t_x_over <= "1" when setup_frame_t_x_cut(22) = '0' and (or setup_frame_t_x_cut(21 downto 19)) = '1' else "0";
    setup_frame_t_x_under <= "1" when setup_frame_t_x_cut(22) = '1' and (and setup_frame_t_x_cut(21 downto 19)) = '0' else "0";
    setup_frame_t_x <= 20x"7ffff" when setup_frame_t_x_over(0) = '1' else 20x"80000" when setup_frame_t_x_under(0) = '1' else setup_frame_t_x_cut(19 downto 0);
    setup_frame_t_y_sum <= resize(setup_frame_n17_s3, 41) + 41x"00000020000";
    setup_frame_t_y_cut <= setup_frame_t_y_sum(40 downto 18);
    setup_frame_t_y_over <= "1" when setup_frame_t_y_cut(22) = '0' and (or setup_frame_t_y_cut(21 downto 19)) = '1' else "0";
    setup_frame_t_y_under <= "1" when setup_frame_t_y_cut(22) = '1' and (and setup_frame_t_y_cut(21 downto 19)) = '0' else "0";
    setup_frame_t_y <= 20x"7ffff" when setup_frame_t_y_over(0) = '1' else 20x"80000" when setup_frame_t_y_under(0) = '1' else setup_frame_t_y_cut(19 downto 0);
    setup_frame_n_x_sum <= resize(setup_frame_n19_s3, 41) + 41x"00000020000";
    setup_frame_n_x_cut <= setup_frame_n_x_sum(40 downto 18);
    setup_frame_n_x_over <= "1" when setup_frame_n_x_cut(22) = '0' and (or setup_frame_n_x_cut(21 downto 19)) = '1' else "0";
    setup_frame_n_x_under <= "1" when setup_frame_n_x_cut(22) = '1' and (and setup_frame_n_x_cut(21 downto 19)) = '0' else "0";
    setup_frame_n_x <= 20x"7ffff" when setup_frame_n_x_over(0) = '1' else 20x"80000" when setup_frame_n_x_under(0) = '1' else setup_frame_n_x_cut(19 downto 0);
    setup_frame_n_y_sum <= resize(setup_frame_n21_s3, 41) + 41x"00000020000";
    setup_frame_n_y_cut <= setup_frame_n_y_sum(40 downto 18);
    setup_frame_n_y_over <= "1" when setup_frame_n_y_cut(22) = '0' and (or setup_frame_n_y_cut(21 downto 19)) = '1' else "0";
    setup_frame_n_y_under <= "1" when setup_frame_n_y_cut(22) = '1' and (and setup_frame_n_y_cut(21 downto 19)) = '0' else "0";
    setup_frame_n_y <= 20x"7ffff" when setup_frame_n_y_over(0) = '1' else 20x"80000" when setup_frame_n_y_under(0) = '1' else setup_frame_n_y_cut(19 downto 0);
    -- setup.light
    setup_light_world_x_sum <= resize(setup_light_n29_s3, 41) + 41x"00000020000";
    setup_light_world_x_cut <= setup_light_world_x_sum(40 downto 18);
    setup_light_world_x_over <= "1" when setup_light_world_x_cut(22) = '0' and (or setup_light_world_x_cut(21 downto 19)) = '1' else "0";
    setup_light_world_x_under <= "1" when setup_light_world_x_cut(22) = '1' and (and setup_light_world_x_cut(21 downto 19)) = '0' else "0";
    setup_light_world_x <= 20x"7ffff" when setup_light_world_x_over(0) = '1' else 20x"80000" when setup_light_world_x_under(0) = '1' else setup_light_world_x_cut(19 downto 0);
    setup_light_world_y_sum <= resize(setup_light_n31_s3, 41) + 41x"00000020000";
    setup_light_world_y_cut <= setup_light_world_y_sum(40 downto 18);
    setup_light_world_y_over <= "1" when setup_light_world_y_cut(22) = '0' and (or setup_light_world_y_cut(21 downto 19)) = '1' else "0";
    setup_light_world_y_under <= "1" when setup_light_world_y_cut(22) = '1' and (and setup_light_world_y_cut(21 downto 19)) = '0' else "0";
    setup_light_world_y <= 20x"7ffff" when setup_light_world_y_over(0) = '1' else 20x"80000" when setup_light_world_y_under(0) = '1' else setup_light_world_y_cut(19 downto 0);
    -- setup.half
    setup_half_world_x_sum <= resize(setup_half_n121_s3, 41) + 41x"00000020000";
    setup_half_world_x_cut <= setup_half_world_x_sum(40 downto 18);
    setup_half_world_x_over <= "1" when setup_half_world_x_cut(22) = '0' and (or setup_half_world_x_cut(21 downto 19)) = '1' else "0";
    setup_half_world_x_under <= "1" when setup_half_world_x_cut(22) = '1' and (and setup_half_world_x_cut(21 downto 19)) = '0' else "0";
    setup_half_world_x <= 20x"7ffff" when setup_half_world_x_over(0) = '1' else 20x"80000" when setup_half_world_x_under(0) = '1' else setup_half_world_x_cut(19 downto 0);
    setup_half_world_y_sum <= resize(setup_half_n123_s3, 41) + 41x"00000020000";
    setup_half_world_y_cut <= setup_half_world_y_sum(40 downto 18);
    setup_half_world_y_over <= "1" when setup_half_world_y_cut(22) = '0' and (or setup_half_world_y_cut(21 downto 19)) = '1' else "0";
    setup_half_world_y_under <= "1" when setup_half_world_y_cut(22) = '1' and (and setup_half_world_y_cut(21 downto 19)) = '0' else "0";
    setup_half_world_y <= 20x"7ffff" when setup_half_world_y_over(0) = '1' else 20x"80000" when setup_half_world_y_under(0) = '1' else setup_half_world_y_cut(19 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_frame_sincos_n10_s4 <= setup_frame_sincos_n10_s3;
                setup_frame_sincos_n11_s4 <= setup_frame_sincos_n11_s3;
                setup_frame_t_x_s4 <= setup_frame_t_x;
                setup_frame_t_y_s4 <= setup_frame_t_y;
                setup_frame_n_x_s4 <= setup_frame_n_x;
                setup_frame_n_y_s4 <= setup_frame_n_y;
                setup_light_world_x_s4 <= setup_light_world_x;
                setup_light_world_y_s4 <= setup_light_world_y;
                setup_light_n35_s4 <= setup_light_n35_s3;
                setup_light_n40_s4 <= setup_light_n40_s3;
                setup_half_world_x_s4 <= setup_half_world_x;
                setup_half_world_y_s4 <= setup_half_world_y;
                setup_half_n127_s4 <= setup_half_n127_s3;
                setup_half_n132_s4 <= setup_half_n132_s3;
                setup_phi_p_s4 <= setup_phi_p_s3;
                dot_l_sincos_n215_s4 <= dot_l_sincos_n215_s3;
                dot_l_sincos_n216_s4 <= dot_l_sincos_n216_s3;
            end if;
            if rst = '1' then
                valid_s4 <= '0';
            elsif ce = '1' then
                valid_s4 <= valid_s3;
            end if;
        end if;
    end process;

    -- ---- stage 4 ----
    -- setup.light
    setup_light_n33 <= setup_frame_t_x_s4 * setup_light_world_x_s4;
    setup_light_n34 <= setup_frame_t_y_s4 * setup_light_world_y_s4;
    setup_light_n36 <= setup_frame_sincos_n10_s4 * setup_light_world_x_s4;
    setup_light_n37 <= setup_frame_sincos_n11_s4 * setup_light_world_y_s4;
    setup_light_n38 <= setup_frame_n_x_s4 * setup_light_world_x_s4;
    setup_light_n39 <= setup_frame_n_y_s4 * setup_light_world_y_s4;
    -- setup.half
    setup_half_n125 <= setup_frame_t_x_s4 * setup_half_world_x_s4;
    setup_half_n126 <= setup_frame_t_y_s4 * setup_half_world_y_s4;
    setup_half_n128 <= setup_frame_sincos_n10_s4 * setup_half_world_x_s4;
    setup_half_n129 <= setup_frame_sincos_n11_s4 * setup_half_world_y_s4;
    setup_half_n130 <= setup_frame_n_x_s4 * setup_half_world_x_s4;
    setup_half_n131 <= setup_frame_n_y_s4 * setup_half_world_y_s4;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_n33_s5 <= setup_light_n33;
                setup_light_n34_s5 <= setup_light_n34;
                setup_light_n35_s5 <= setup_light_n35_s4;
                setup_light_n36_s5 <= setup_light_n36;
                setup_light_n37_s5 <= setup_light_n37;
                setup_light_n38_s5 <= setup_light_n38;
                setup_light_n39_s5 <= setup_light_n39;
                setup_light_n40_s5 <= setup_light_n40_s4;
                setup_half_n125_s5 <= setup_half_n125;
                setup_half_n126_s5 <= setup_half_n126;
                setup_half_n127_s5 <= setup_half_n127_s4;
                setup_half_n128_s5 <= setup_half_n128;
                setup_half_n129_s5 <= setup_half_n129;
                setup_half_n130_s5 <= setup_half_n130;
                setup_half_n131_s5 <= setup_half_n131;
                setup_half_n132_s5 <= setup_half_n132_s4;
                setup_phi_p_s5 <= setup_phi_p_s4;
                dot_l_sincos_n215_s5 <= dot_l_sincos_n215_s4;
                dot_l_sincos_n216_s5 <= dot_l_sincos_n216_s4;
            end if;
            if rst = '1' then
                valid_s5 <= '0';
            elsif ce = '1' then
                valid_s5 <= valid_s4;
            end if;
        end if;
    end process;

    -- ---- stage 5 ----
    -- setup.light
    setup_light_n41 <= resize(setup_light_n33_s5, 41) + resize(setup_light_n34_s5, 41);
    setup_light_n42 <= resize(setup_light_n41, 42) - resize(setup_light_n35_s5, 42);
    setup_light_n43 <= resize(setup_light_n37_s5, 41) - resize(setup_light_n36_s5, 41);
    setup_light_n44 <= resize(setup_light_n38_s5, 41) + resize(setup_light_n39_s5, 41);
    setup_light_n45 <= resize(setup_light_n44, 42) + resize(setup_light_n40_s5, 42);
    setup_light_y_sum <= resize(setup_light_n43, 42) + 42x"00000020000";
    setup_light_y_cut <= setup_light_y_sum(41 downto 18);
    setup_light_y_over <= "1" when setup_light_y_cut(23) = '0' and (or setup_light_y_cut(22 downto 19)) = '1' else "0";
    setup_light_y_under <= "1" when setup_light_y_cut(23) = '1' and (and setup_light_y_cut(22 downto 19)) = '0' else "0";
    setup_light_y <= 20x"7ffff" when setup_light_y_over(0) = '1' else 20x"80000" when setup_light_y_under(0) = '1' else setup_light_y_cut(19 downto 0);
    -- setup.light.azimuth
    setup_light_azimuth_n50_neg <= unsigned(-setup_light_y);
    setup_light_azimuth_n50 <= setup_light_azimuth_n50_neg when setup_light_y(19) = '1' else unsigned(setup_light_y);
    setup_light_azimuth_n76 <= unsigned(setup_light_y(19 downto 19));
    -- setup.half
    setup_half_n133 <= resize(setup_half_n125_s5, 41) + resize(setup_half_n126_s5, 41);
    setup_half_n134 <= resize(setup_half_n133, 42) - resize(setup_half_n127_s5, 42);
    setup_half_n135 <= resize(setup_half_n129_s5, 41) - resize(setup_half_n128_s5, 41);
    setup_half_n136 <= resize(setup_half_n130_s5, 41) + resize(setup_half_n131_s5, 41);
    setup_half_n137 <= resize(setup_half_n136, 42) + resize(setup_half_n132_s5, 42);
    setup_half_y_sum <= resize(setup_half_n135, 42) + 42x"00000020000";
    setup_half_y_cut <= setup_half_y_sum(41 downto 18);
    setup_half_y_over <= "1" when setup_half_y_cut(23) = '0' and (or setup_half_y_cut(22 downto 19)) = '1' else "0";
    setup_half_y_under <= "1" when setup_half_y_cut(23) = '1' and (and setup_half_y_cut(22 downto 19)) = '0' else "0";
    setup_half_y <= 20x"7ffff" when setup_half_y_over(0) = '1' else 20x"80000" when setup_half_y_under(0) = '1' else setup_half_y_cut(19 downto 0);
    -- setup.half.azimuth
    setup_half_azimuth_n142_neg <= unsigned(-setup_half_y);
    setup_half_azimuth_n142 <= setup_half_azimuth_n142_neg when setup_half_y(19) = '1' else unsigned(setup_half_y);
    setup_half_azimuth_n166 <= unsigned(setup_half_y(19 downto 19));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_n42_s6 <= setup_light_n42;
                setup_light_n45_s6 <= setup_light_n45;
                setup_light_azimuth_n50_s6 <= setup_light_azimuth_n50;
                setup_light_azimuth_n76_s6 <= setup_light_azimuth_n76;
                setup_half_n134_s6 <= setup_half_n134;
                setup_half_n137_s6 <= setup_half_n137;
                setup_half_azimuth_n142_s6 <= setup_half_azimuth_n142;
                setup_half_azimuth_n166_s6 <= setup_half_azimuth_n166;
                setup_phi_p_s6 <= setup_phi_p_s5;
                dot_l_sincos_n215_s6 <= dot_l_sincos_n215_s5;
                dot_l_sincos_n216_s6 <= dot_l_sincos_n216_s5;
            end if;
            if rst = '1' then
                valid_s6 <= '0';
            elsif ce = '1' then
                valid_s6 <= valid_s5;
            end if;
        end if;
    end process;

    -- ---- stage 6 ----
    -- setup.light
    setup_light_x_sum <= resize(setup_light_n42_s6, 43) + 43x"00000020000";
    setup_light_x_cut <= setup_light_x_sum(42 downto 18);
    setup_light_x_over <= "1" when setup_light_x_cut(24) = '0' and (or setup_light_x_cut(23 downto 19)) = '1' else "0";
    setup_light_x_under <= "1" when setup_light_x_cut(24) = '1' and (and setup_light_x_cut(23 downto 19)) = '0' else "0";
    setup_light_x <= 20x"7ffff" when setup_light_x_over(0) = '1' else 20x"80000" when setup_light_x_under(0) = '1' else setup_light_x_cut(19 downto 0);
    setup_light_z_sum <= resize(setup_light_n45_s6, 43) + 43x"00000020000";
    setup_light_z_cut <= setup_light_z_sum(42 downto 18);
    setup_light_z_over <= "1" when setup_light_z_cut(24) = '0' and (or setup_light_z_cut(23 downto 19)) = '1' else "0";
    setup_light_z_under <= "1" when setup_light_z_cut(24) = '1' and (and setup_light_z_cut(23 downto 19)) = '0' else "0";
    setup_light_z <= 20x"7ffff" when setup_light_z_over(0) = '1' else 20x"80000" when setup_light_z_under(0) = '1' else setup_light_z_cut(19 downto 0);
    -- setup.light.azimuth
    setup_light_azimuth_n49_neg <= unsigned(-setup_light_x);
    setup_light_azimuth_n49 <= setup_light_azimuth_n49_neg when setup_light_x(19) = '1' else unsigned(setup_light_x);
    setup_light_azimuth_n51 <= "1" when setup_light_azimuth_n49 < setup_light_azimuth_n50_s6 else "0";
    setup_light_azimuth_n52 <= setup_light_azimuth_n50_s6 when setup_light_azimuth_n51(0) = '1' else setup_light_azimuth_n49;
    setup_light_azimuth_n53 <= setup_light_azimuth_n49 when setup_light_azimuth_n51(0) = '1' else setup_light_azimuth_n50_s6;
    setup_light_azimuth_n72 <= unsigned(setup_light_x(19 downto 19));
    -- setup.light.polar_angle
    setup_light_polar_angle_n83_neg <= unsigned(-setup_light_z);
    setup_light_polar_angle_n83 <= setup_light_polar_angle_n83_neg when setup_light_z(19) = '1' else unsigned(setup_light_z);
    setup_light_polar_angle_n104 <= unsigned(setup_light_z(19 downto 19));
    -- setup.half
    setup_half_x_sum <= resize(setup_half_n134_s6, 43) + 43x"00000020000";
    setup_half_x_cut <= setup_half_x_sum(42 downto 18);
    setup_half_x_over <= "1" when setup_half_x_cut(24) = '0' and (or setup_half_x_cut(23 downto 19)) = '1' else "0";
    setup_half_x_under <= "1" when setup_half_x_cut(24) = '1' and (and setup_half_x_cut(23 downto 19)) = '0' else "0";
    setup_half_x <= 20x"7ffff" when setup_half_x_over(0) = '1' else 20x"80000" when setup_half_x_under(0) = '1' else setup_half_x_cut(19 downto 0);
    setup_half_z_sum <= resize(setup_half_n137_s6, 43) + 43x"00000020000";
    setup_half_z_cut <= setup_half_z_sum(42 downto 18);
    setup_half_z_over <= "1" when setup_half_z_cut(24) = '0' and (or setup_half_z_cut(23 downto 19)) = '1' else "0";
    setup_half_z_under <= "1" when setup_half_z_cut(24) = '1' and (and setup_half_z_cut(23 downto 19)) = '0' else "0";
    setup_half_z <= 20x"7ffff" when setup_half_z_over(0) = '1' else 20x"80000" when setup_half_z_under(0) = '1' else setup_half_z_cut(19 downto 0);
    -- setup.half.azimuth
    setup_half_azimuth_n141_neg <= unsigned(-setup_half_x);
    setup_half_azimuth_n141 <= setup_half_azimuth_n141_neg when setup_half_x(19) = '1' else unsigned(setup_half_x);
    setup_half_azimuth_n143 <= "1" when setup_half_azimuth_n141 < setup_half_azimuth_n142_s6 else "0";
    setup_half_azimuth_n144 <= setup_half_azimuth_n142_s6 when setup_half_azimuth_n143(0) = '1' else setup_half_azimuth_n141;
    setup_half_azimuth_n145 <= setup_half_azimuth_n141 when setup_half_azimuth_n143(0) = '1' else setup_half_azimuth_n142_s6;
    setup_half_azimuth_n163 <= unsigned(setup_half_x(19 downto 19));
    -- setup.half.polar_angle
    setup_half_polar_angle_n173_neg <= unsigned(-setup_half_z);
    setup_half_polar_angle_n173 <= setup_half_polar_angle_n173_neg when setup_half_z(19) = '1' else unsigned(setup_half_z);
    setup_half_polar_angle_n194 <= unsigned(setup_half_z(19 downto 19));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_azimuth_n51_s7 <= setup_light_azimuth_n51;
                setup_light_azimuth_n52_s7 <= setup_light_azimuth_n52;
                setup_light_azimuth_n53_s7 <= setup_light_azimuth_n53;
                setup_light_azimuth_n72_s7 <= setup_light_azimuth_n72;
                setup_light_azimuth_n76_s7 <= setup_light_azimuth_n76_s6;
                setup_light_polar_angle_n83_s7 <= setup_light_polar_angle_n83;
                setup_light_polar_angle_n104_s7 <= setup_light_polar_angle_n104;
                setup_half_azimuth_n143_s7 <= setup_half_azimuth_n143;
                setup_half_azimuth_n144_s7 <= setup_half_azimuth_n144;
                setup_half_azimuth_n145_s7 <= setup_half_azimuth_n145;
                setup_half_azimuth_n163_s7 <= setup_half_azimuth_n163;
                setup_half_azimuth_n166_s7 <= setup_half_azimuth_n166_s6;
                setup_half_polar_angle_n173_s7 <= setup_half_polar_angle_n173;
                setup_half_polar_angle_n194_s7 <= setup_half_polar_angle_n194;
                setup_phi_p_s7 <= setup_phi_p_s6;
                dot_l_sincos_n215_s7 <= dot_l_sincos_n215_s6;
                dot_l_sincos_n216_s7 <= dot_l_sincos_n216_s6;
            end if;
            if rst = '1' then
                valid_s7 <= '0';
            elsif ce = '1' then
                valid_s7 <= valid_s6;
            end if;
        end if;
    end process;

    -- ---- stage 7 ----
    -- setup.light.azimuth
    setup_light_azimuth_n54_padded <= setup_light_azimuth_n52_s7 & 12x"fff";
    setup_light_azimuth_n54_skip16 <= "1" when setup_light_azimuth_n54_padded(31 downto 16) = 16x"0000" else "0";
    setup_light_azimuth_n54_part16 <= setup_light_azimuth_n54_padded(15 downto 0) when setup_light_azimuth_n54_skip16(0) = '1' else setup_light_azimuth_n54_padded(31 downto 16);
    setup_light_azimuth_n54_skip8 <= "1" when setup_light_azimuth_n54_part16(15 downto 8) = 8x"00" else "0";
    setup_light_azimuth_n54_part8 <= setup_light_azimuth_n54_part16(7 downto 0) when setup_light_azimuth_n54_skip8(0) = '1' else setup_light_azimuth_n54_part16(15 downto 8);
    setup_light_azimuth_n54_skip4 <= "1" when setup_light_azimuth_n54_part8(7 downto 4) = 4x"0" else "0";
    setup_light_azimuth_n54_part4 <= setup_light_azimuth_n54_part8(3 downto 0) when setup_light_azimuth_n54_skip4(0) = '1' else setup_light_azimuth_n54_part8(7 downto 4);
    setup_light_azimuth_n54_skip2 <= "1" when setup_light_azimuth_n54_part4(3 downto 2) = "00" else "0";
    setup_light_azimuth_n54_part2 <= setup_light_azimuth_n54_part4(1 downto 0) when setup_light_azimuth_n54_skip2(0) = '1' else setup_light_azimuth_n54_part4(3 downto 2);
    setup_light_azimuth_n54_skip1 <= "1" when setup_light_azimuth_n54_part2(1 downto 1) = "0" else "0";
    setup_light_azimuth_n54 <= setup_light_azimuth_n54_skip16 & setup_light_azimuth_n54_skip8 & setup_light_azimuth_n54_skip4 & setup_light_azimuth_n54_skip2 & setup_light_azimuth_n54_skip1;
    setup_light_azimuth_n55_past <= "1" when 5x"14" < setup_light_azimuth_n54 else "0";
    setup_light_azimuth_n55_count <= 5x"14" when setup_light_azimuth_n55_past(0) = '1' else setup_light_azimuth_n54;
    setup_light_azimuth_n55 <= shift_left(resize(setup_light_azimuth_n52_s7, 40), to_integer(setup_light_azimuth_n55_count));
    setup_light_azimuth_n56 <= setup_light_azimuth_n55(19 downto 0);
    setup_light_azimuth_n57_past <= "1" when 5x"14" < setup_light_azimuth_n54 else "0";
    setup_light_azimuth_n57_count <= 5x"14" when setup_light_azimuth_n57_past(0) = '1' else setup_light_azimuth_n54;
    setup_light_azimuth_n57 <= shift_left(resize(setup_light_azimuth_n53_s7, 40), to_integer(setup_light_azimuth_n57_count));
    setup_light_azimuth_n58 <= setup_light_azimuth_n57(19 downto 0);
    setup_light_azimuth_n59 <= setup_light_azimuth_n56(18 downto 0);
    setup_light_azimuth_n60 <= setup_light_azimuth_n59;
    -- setup.light.azimuth.recip
    setup_light_azimuth_recip_n61 <= setup_light_azimuth_n60(18 downto 9);
    -- setup.light.azimuth
    setup_light_azimuth_n63 <= setup_light_azimuth_n58;
    -- setup.half.azimuth
    setup_half_azimuth_n146_padded <= setup_half_azimuth_n144_s7 & 12x"fff";
    setup_half_azimuth_n146_skip16 <= "1" when setup_half_azimuth_n146_padded(31 downto 16) = 16x"0000" else "0";
    setup_half_azimuth_n146_part16 <= setup_half_azimuth_n146_padded(15 downto 0) when setup_half_azimuth_n146_skip16(0) = '1' else setup_half_azimuth_n146_padded(31 downto 16);
    setup_half_azimuth_n146_skip8 <= "1" when setup_half_azimuth_n146_part16(15 downto 8) = 8x"00" else "0";
    setup_half_azimuth_n146_part8 <= setup_half_azimuth_n146_part16(7 downto 0) when setup_half_azimuth_n146_skip8(0) = '1' else setup_half_azimuth_n146_part16(15 downto 8);
    setup_half_azimuth_n146_skip4 <= "1" when setup_half_azimuth_n146_part8(7 downto 4) = 4x"0" else "0";
    setup_half_azimuth_n146_part4 <= setup_half_azimuth_n146_part8(3 downto 0) when setup_half_azimuth_n146_skip4(0) = '1' else setup_half_azimuth_n146_part8(7 downto 4);
    setup_half_azimuth_n146_skip2 <= "1" when setup_half_azimuth_n146_part4(3 downto 2) = "00" else "0";
    setup_half_azimuth_n146_part2 <= setup_half_azimuth_n146_part4(1 downto 0) when setup_half_azimuth_n146_skip2(0) = '1' else setup_half_azimuth_n146_part4(3 downto 2);
    setup_half_azimuth_n146_skip1 <= "1" when setup_half_azimuth_n146_part2(1 downto 1) = "0" else "0";
    setup_half_azimuth_n146 <= setup_half_azimuth_n146_skip16 & setup_half_azimuth_n146_skip8 & setup_half_azimuth_n146_skip4 & setup_half_azimuth_n146_skip2 & setup_half_azimuth_n146_skip1;
    setup_half_azimuth_n147_past <= "1" when 5x"14" < setup_half_azimuth_n146 else "0";
    setup_half_azimuth_n147_count <= 5x"14" when setup_half_azimuth_n147_past(0) = '1' else setup_half_azimuth_n146;
    setup_half_azimuth_n147 <= shift_left(resize(setup_half_azimuth_n144_s7, 40), to_integer(setup_half_azimuth_n147_count));
    setup_half_azimuth_n148 <= setup_half_azimuth_n147(19 downto 0);
    setup_half_azimuth_n149_past <= "1" when 5x"14" < setup_half_azimuth_n146 else "0";
    setup_half_azimuth_n149_count <= 5x"14" when setup_half_azimuth_n149_past(0) = '1' else setup_half_azimuth_n146;
    setup_half_azimuth_n149 <= shift_left(resize(setup_half_azimuth_n145_s7, 40), to_integer(setup_half_azimuth_n149_count));
    setup_half_azimuth_n150 <= setup_half_azimuth_n149(19 downto 0);
    setup_half_azimuth_n151 <= setup_half_azimuth_n148(18 downto 0);
    setup_half_azimuth_n152 <= setup_half_azimuth_n151;
    -- setup.half.azimuth.recip
    setup_half_azimuth_recip_n153 <= setup_half_azimuth_n152(18 downto 9);
    -- setup.half.azimuth
    setup_half_azimuth_n155 <= setup_half_azimuth_n150;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_azimuth_n51_s8 <= setup_light_azimuth_n51_s7;
                setup_light_azimuth_n52_s8 <= setup_light_azimuth_n52_s7;
                setup_light_azimuth_recip_n61_s8 <= setup_light_azimuth_recip_n61;
                setup_light_azimuth_n63_s8 <= setup_light_azimuth_n63;
                setup_light_azimuth_n72_s8 <= setup_light_azimuth_n72_s7;
                setup_light_azimuth_n76_s8 <= setup_light_azimuth_n76_s7;
                setup_light_polar_angle_n83_s8 <= setup_light_polar_angle_n83_s7;
                setup_light_polar_angle_n104_s8 <= setup_light_polar_angle_n104_s7;
                setup_half_azimuth_n143_s8 <= setup_half_azimuth_n143_s7;
                setup_half_azimuth_n144_s8 <= setup_half_azimuth_n144_s7;
                setup_half_azimuth_recip_n153_s8 <= setup_half_azimuth_recip_n153;
                setup_half_azimuth_n155_s8 <= setup_half_azimuth_n155;
                setup_half_azimuth_n163_s8 <= setup_half_azimuth_n163_s7;
                setup_half_azimuth_n166_s8 <= setup_half_azimuth_n166_s7;
                setup_half_polar_angle_n173_s8 <= setup_half_polar_angle_n173_s7;
                setup_half_polar_angle_n194_s8 <= setup_half_polar_angle_n194_s7;
                setup_phi_p_s8 <= setup_phi_p_s7;
                dot_l_sincos_n215_s8 <= dot_l_sincos_n215_s7;
                dot_l_sincos_n216_s8 <= dot_l_sincos_n216_s7;
            end if;
            if rst = '1' then
                valid_s8 <= '0';
            elsif ce = '1' then
                valid_s8 <= valid_s7;
            end if;
        end if;
    end process;

    -- ---- stage 8 ----

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_azimuth_n51_s9 <= setup_light_azimuth_n51_s8;
                setup_light_azimuth_n52_s9 <= setup_light_azimuth_n52_s8;
                recip_row <= recip_rom(to_integer(setup_light_azimuth_recip_n61_s8));
                setup_light_azimuth_n63_s9 <= setup_light_azimuth_n63_s8;
                setup_light_azimuth_n72_s9 <= setup_light_azimuth_n72_s8;
                setup_light_azimuth_n76_s9 <= setup_light_azimuth_n76_s8;
                setup_light_polar_angle_n83_s9 <= setup_light_polar_angle_n83_s8;
                setup_light_polar_angle_n104_s9 <= setup_light_polar_angle_n104_s8;
                setup_half_azimuth_n143_s9 <= setup_half_azimuth_n143_s8;
                setup_half_azimuth_n144_s9 <= setup_half_azimuth_n144_s8;
                recip_row_2 <= recip_rom(to_integer(setup_half_azimuth_recip_n153_s8));
                setup_half_azimuth_n155_s9 <= setup_half_azimuth_n155_s8;
                setup_half_azimuth_n163_s9 <= setup_half_azimuth_n163_s8;
                setup_half_azimuth_n166_s9 <= setup_half_azimuth_n166_s8;
                setup_half_polar_angle_n173_s9 <= setup_half_polar_angle_n173_s8;
                setup_half_polar_angle_n194_s9 <= setup_half_polar_angle_n194_s8;
                setup_phi_p_s9 <= setup_phi_p_s8;
                dot_l_sincos_n215_s9 <= dot_l_sincos_n215_s8;
                dot_l_sincos_n216_s9 <= dot_l_sincos_n216_s8;
            end if;
            if rst = '1' then
                valid_s9 <= '0';
            elsif ce = '1' then
                valid_s9 <= valid_s8;
            end if;
        end if;
    end process;

    -- ---- stage 9 ----
    -- setup.light.azimuth.recip
    setup_light_azimuth_recip_n62 <= recip_row;
    -- setup.half.azimuth.recip
    setup_half_azimuth_recip_n154 <= recip_row_2;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_azimuth_n51_s10 <= setup_light_azimuth_n51_s9;
                setup_light_azimuth_n52_s10 <= setup_light_azimuth_n52_s9;
                setup_light_azimuth_recip_n62_s10 <= setup_light_azimuth_recip_n62;
                setup_light_azimuth_n63_s10 <= setup_light_azimuth_n63_s9;
                setup_light_azimuth_n72_s10 <= setup_light_azimuth_n72_s9;
                setup_light_azimuth_n76_s10 <= setup_light_azimuth_n76_s9;
                setup_light_polar_angle_n83_s10 <= setup_light_polar_angle_n83_s9;
                setup_light_polar_angle_n104_s10 <= setup_light_polar_angle_n104_s9;
                setup_half_azimuth_n143_s10 <= setup_half_azimuth_n143_s9;
                setup_half_azimuth_n144_s10 <= setup_half_azimuth_n144_s9;
                setup_half_azimuth_recip_n154_s10 <= setup_half_azimuth_recip_n154;
                setup_half_azimuth_n155_s10 <= setup_half_azimuth_n155_s9;
                setup_half_azimuth_n163_s10 <= setup_half_azimuth_n163_s9;
                setup_half_azimuth_n166_s10 <= setup_half_azimuth_n166_s9;
                setup_half_polar_angle_n173_s10 <= setup_half_polar_angle_n173_s9;
                setup_half_polar_angle_n194_s10 <= setup_half_polar_angle_n194_s9;
                setup_phi_p_s10 <= setup_phi_p_s9;
                dot_l_sincos_n215_s10 <= dot_l_sincos_n215_s9;
                dot_l_sincos_n216_s10 <= dot_l_sincos_n216_s9;
            end if;
            if rst = '1' then
                valid_s10 <= '0';
            elsif ce = '1' then
                valid_s10 <= valid_s9;
            end if;
        end if;
    end process;

    -- ---- stage 10 ----
    -- setup.light.azimuth
    setup_light_azimuth_n64 <= setup_light_azimuth_n63_s10 * setup_light_azimuth_recip_n62_s10;
    -- setup.half.azimuth
    setup_half_azimuth_n156 <= setup_half_azimuth_n155_s10 * setup_half_azimuth_recip_n154_s10;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_azimuth_n51_s11 <= setup_light_azimuth_n51_s10;
                setup_light_azimuth_n52_s11 <= setup_light_azimuth_n52_s10;
                setup_light_azimuth_n64_s11 <= setup_light_azimuth_n64;
                setup_light_azimuth_n72_s11 <= setup_light_azimuth_n72_s10;
                setup_light_azimuth_n76_s11 <= setup_light_azimuth_n76_s10;
                setup_light_polar_angle_n83_s11 <= setup_light_polar_angle_n83_s10;
                setup_light_polar_angle_n104_s11 <= setup_light_polar_angle_n104_s10;
                setup_half_azimuth_n143_s11 <= setup_half_azimuth_n143_s10;
                setup_half_azimuth_n144_s11 <= setup_half_azimuth_n144_s10;
                setup_half_azimuth_n156_s11 <= setup_half_azimuth_n156;
                setup_half_azimuth_n163_s11 <= setup_half_azimuth_n163_s10;
                setup_half_azimuth_n166_s11 <= setup_half_azimuth_n166_s10;
                setup_half_polar_angle_n173_s11 <= setup_half_polar_angle_n173_s10;
                setup_half_polar_angle_n194_s11 <= setup_half_polar_angle_n194_s10;
                setup_phi_p_s11 <= setup_phi_p_s10;
                dot_l_sincos_n215_s11 <= dot_l_sincos_n215_s10;
                dot_l_sincos_n216_s11 <= dot_l_sincos_n216_s10;
            end if;
            if rst = '1' then
                valid_s11 <= '0';
            elsif ce = '1' then
                valid_s11 <= valid_s10;
            end if;
        end if;
    end process;

    -- ---- stage 11 ----
    -- setup.light.azimuth
    setup_light_azimuth_ratio_sum <= resize(setup_light_azimuth_n64_s11, 41) + 41x"00000080000";
    setup_light_azimuth_ratio_cut <= setup_light_azimuth_ratio_sum(40 downto 20);
    setup_light_azimuth_ratio_over <= "1" when (or setup_light_azimuth_ratio_cut(20 downto 18)) = '1' else "0";
    setup_light_azimuth_ratio <= 18x"3ffff" when setup_light_azimuth_ratio_over(0) = '1' else setup_light_azimuth_ratio_cut(17 downto 0);
    -- setup.light.azimuth.atan
    setup_light_azimuth_atan_n66 <= setup_light_azimuth_ratio(17 downto 8);
    -- setup.half.azimuth
    setup_half_azimuth_ratio_sum <= resize(setup_half_azimuth_n156_s11, 41) + 41x"00000080000";
    setup_half_azimuth_ratio_cut <= setup_half_azimuth_ratio_sum(40 downto 20);
    setup_half_azimuth_ratio_over <= "1" when (or setup_half_azimuth_ratio_cut(20 downto 18)) = '1' else "0";
    setup_half_azimuth_ratio <= 18x"3ffff" when setup_half_azimuth_ratio_over(0) = '1' else setup_half_azimuth_ratio_cut(17 downto 0);
    -- setup.half.azimuth.atan
    setup_half_azimuth_atan_n158 <= setup_half_azimuth_ratio(17 downto 8);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_azimuth_n51_s12 <= setup_light_azimuth_n51_s11;
                setup_light_azimuth_n52_s12 <= setup_light_azimuth_n52_s11;
                atan_row <= atan_rom(to_integer(setup_light_azimuth_atan_n66));
                setup_light_azimuth_n72_s12 <= setup_light_azimuth_n72_s11;
                setup_light_azimuth_n76_s12 <= setup_light_azimuth_n76_s11;
                setup_light_polar_angle_n83_s12 <= setup_light_polar_angle_n83_s11;
                setup_light_polar_angle_n104_s12 <= setup_light_polar_angle_n104_s11;
                setup_half_azimuth_n143_s12 <= setup_half_azimuth_n143_s11;
                setup_half_azimuth_n144_s12 <= setup_half_azimuth_n144_s11;
                atan_row_2 <= atan_rom(to_integer(setup_half_azimuth_atan_n158));
                setup_half_azimuth_n163_s12 <= setup_half_azimuth_n163_s11;
                setup_half_azimuth_n166_s12 <= setup_half_azimuth_n166_s11;
                setup_half_polar_angle_n173_s12 <= setup_half_polar_angle_n173_s11;
                setup_half_polar_angle_n194_s12 <= setup_half_polar_angle_n194_s11;
                setup_phi_p_s12 <= setup_phi_p_s11;
                dot_l_sincos_n215_s12 <= dot_l_sincos_n215_s11;
                dot_l_sincos_n216_s12 <= dot_l_sincos_n216_s11;
            end if;
            if rst = '1' then
                valid_s12 <= '0';
            elsif ce = '1' then
                valid_s12 <= valid_s11;
            end if;
        end if;
    end process;

    -- ---- stage 12 ----
    -- setup.light.azimuth.atan
    setup_light_azimuth_atan_n67 <= atan_row(37 downto 19);
    setup_light_azimuth_atan_n68 <= atan_row(18 downto 0);
    -- setup.light.azimuth
    setup_light_azimuth_n70 <= signed(resize(setup_light_azimuth_n69, 20)) - signed(resize(setup_light_azimuth_atan_n67, 20));
    setup_light_azimuth_n71 <= setup_light_azimuth_n70 when setup_light_azimuth_n51_s12(0) = '1' else signed(resize(setup_light_azimuth_atan_n67, 20));
    -- setup.half.azimuth.atan
    setup_half_azimuth_atan_n159 <= atan_row_2(37 downto 19);
    setup_half_azimuth_atan_n160 <= atan_row_2(18 downto 0);
    -- setup.half.azimuth
    setup_half_azimuth_n161 <= signed(resize(setup_light_azimuth_n69, 20)) - signed(resize(setup_half_azimuth_atan_n159, 20));
    setup_half_azimuth_n162 <= setup_half_azimuth_n161 when setup_half_azimuth_n143_s12(0) = '1' else signed(resize(setup_half_azimuth_atan_n159, 20));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_azimuth_n52_s13 <= setup_light_azimuth_n52_s12;
                setup_light_azimuth_atan_n68_s13 <= setup_light_azimuth_atan_n68;
                setup_light_azimuth_n71_s13 <= setup_light_azimuth_n71;
                setup_light_azimuth_n72_s13 <= setup_light_azimuth_n72_s12;
                setup_light_azimuth_n76_s13 <= setup_light_azimuth_n76_s12;
                setup_light_polar_angle_n83_s13 <= setup_light_polar_angle_n83_s12;
                setup_light_polar_angle_n104_s13 <= setup_light_polar_angle_n104_s12;
                setup_half_azimuth_n144_s13 <= setup_half_azimuth_n144_s12;
                setup_half_azimuth_atan_n160_s13 <= setup_half_azimuth_atan_n160;
                setup_half_azimuth_n162_s13 <= setup_half_azimuth_n162;
                setup_half_azimuth_n163_s13 <= setup_half_azimuth_n163_s12;
                setup_half_azimuth_n166_s13 <= setup_half_azimuth_n166_s12;
                setup_half_polar_angle_n173_s13 <= setup_half_polar_angle_n173_s12;
                setup_half_polar_angle_n194_s13 <= setup_half_polar_angle_n194_s12;
                setup_phi_p_s13 <= setup_phi_p_s12;
                dot_l_sincos_n215_s13 <= dot_l_sincos_n215_s12;
                dot_l_sincos_n216_s13 <= dot_l_sincos_n216_s12;
            end if;
            if rst = '1' then
                valid_s13 <= '0';
            elsif ce = '1' then
                valid_s13 <= valid_s12;
            end if;
        end if;
    end process;

    -- ---- stage 13 ----
    -- setup.light.azimuth
    setup_light_azimuth_n74 <= signed(resize(setup_light_azimuth_n73, 21)) - resize(setup_light_azimuth_n71_s13, 21);
    setup_light_azimuth_n75 <= setup_light_azimuth_n74 when setup_light_azimuth_n72_s13(0) = '1' else resize(setup_light_azimuth_n71_s13, 21);
    setup_light_azimuth_n77 <= -resize(setup_light_azimuth_n75, 22);
    setup_light_azimuth_n78 <= setup_light_azimuth_n77 when setup_light_azimuth_n76_s13(0) = '1' else resize(setup_light_azimuth_n75, 22);
    setup_light_azimuth_n79 <= unsigned(setup_light_azimuth_n78(17 downto 0));
    setup_light_azimuth_n80 <= setup_light_azimuth_n52_s13 * setup_light_azimuth_atan_n68_s13;
    -- setup.light
    setup_light_n111_sum <= resize(setup_light_azimuth_n79, 19) + 19x"00002";
    setup_light_n111_cut <= setup_light_n111_sum(18 downto 2);
    setup_light_n111 <= setup_light_n111_cut;
    setup_light_phi <= setup_light_n111(15 downto 0);
    -- setup.half.azimuth
    setup_half_azimuth_n164 <= signed(resize(setup_light_azimuth_n73, 21)) - resize(setup_half_azimuth_n162_s13, 21);
    setup_half_azimuth_n165 <= setup_half_azimuth_n164 when setup_half_azimuth_n163_s13(0) = '1' else resize(setup_half_azimuth_n162_s13, 21);
    setup_half_azimuth_n167 <= -resize(setup_half_azimuth_n165, 22);
    setup_half_azimuth_n168 <= setup_half_azimuth_n167 when setup_half_azimuth_n166_s13(0) = '1' else resize(setup_half_azimuth_n165, 22);
    setup_half_azimuth_n169 <= unsigned(setup_half_azimuth_n168(17 downto 0));
    setup_half_azimuth_n170 <= setup_half_azimuth_n144_s13 * setup_half_azimuth_atan_n160_s13;
    -- setup.half
    setup_half_n201_sum <= resize(setup_half_azimuth_n169, 19) + 19x"00002";
    setup_half_n201_cut <= setup_half_n201_sum(18 downto 2);
    setup_half_n201 <= setup_half_n201_cut;
    setup_half_phi <= setup_half_n201(15 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_azimuth_n80_s14 <= setup_light_azimuth_n80;
                setup_light_polar_angle_n83_s14 <= setup_light_polar_angle_n83_s13;
                setup_light_polar_angle_n104_s14 <= setup_light_polar_angle_n104_s13;
                setup_light_phi_s14 <= setup_light_phi;
                setup_half_azimuth_n170_s14 <= setup_half_azimuth_n170;
                setup_half_polar_angle_n173_s14 <= setup_half_polar_angle_n173_s13;
                setup_half_polar_angle_n194_s14 <= setup_half_polar_angle_n194_s13;
                setup_half_phi_s14 <= setup_half_phi;
                setup_phi_p_s14 <= setup_phi_p_s13;
                dot_l_sincos_n215_s14 <= dot_l_sincos_n215_s13;
                dot_l_sincos_n216_s14 <= dot_l_sincos_n216_s13;
            end if;
            if rst = '1' then
                valid_s14 <= '0';
            elsif ce = '1' then
                valid_s14 <= valid_s13;
            end if;
        end if;
    end process;

    -- ---- stage 14 ----
    -- setup.light.azimuth
    setup_light_azimuth_n81_sum <= resize(setup_light_azimuth_n80_s14, 40) + 40x"0000020000";
    setup_light_azimuth_n81_cut <= setup_light_azimuth_n81_sum(39 downto 18);
    setup_light_azimuth_n81_over <= "1" when (or setup_light_azimuth_n81_cut(21 downto 20)) = '1' else "0";
    setup_light_azimuth_n81 <= 21x"0fffff" when setup_light_azimuth_n81_over(0) = '1' else signed(setup_light_azimuth_n81_cut(20 downto 0));
    -- setup.light
    setup_light_n82_over <= "1" when setup_light_azimuth_n81(20) = '0' and (or setup_light_azimuth_n81(19 downto 19)) = '1' else "0";
    setup_light_n82_under <= "1" when setup_light_azimuth_n81(20) = '1' and (and setup_light_azimuth_n81(19 downto 19)) = '0' else "0";
    setup_light_n82 <= 20x"7ffff" when setup_light_n82_over(0) = '1' else 20x"80000" when setup_light_n82_under(0) = '1' else setup_light_azimuth_n81(19 downto 0);
    -- setup.light.polar_angle
    setup_light_polar_angle_n84_neg <= unsigned(-setup_light_n82);
    setup_light_polar_angle_n84 <= setup_light_polar_angle_n84_neg when setup_light_n82(19) = '1' else unsigned(setup_light_n82);
    setup_light_polar_angle_n107 <= unsigned(setup_light_n82(19 downto 19));
    -- setup.half.azimuth
    setup_half_azimuth_n171_sum <= resize(setup_half_azimuth_n170_s14, 40) + 40x"0000020000";
    setup_half_azimuth_n171_cut <= setup_half_azimuth_n171_sum(39 downto 18);
    setup_half_azimuth_n171_over <= "1" when (or setup_half_azimuth_n171_cut(21 downto 20)) = '1' else "0";
    setup_half_azimuth_n171 <= 21x"0fffff" when setup_half_azimuth_n171_over(0) = '1' else signed(setup_half_azimuth_n171_cut(20 downto 0));
    -- setup.half
    setup_half_n172_over <= "1" when setup_half_azimuth_n171(20) = '0' and (or setup_half_azimuth_n171(19 downto 19)) = '1' else "0";
    setup_half_n172_under <= "1" when setup_half_azimuth_n171(20) = '1' and (and setup_half_azimuth_n171(19 downto 19)) = '0' else "0";
    setup_half_n172 <= 20x"7ffff" when setup_half_n172_over(0) = '1' else 20x"80000" when setup_half_n172_under(0) = '1' else setup_half_azimuth_n171(19 downto 0);
    -- setup.half.polar_angle
    setup_half_polar_angle_n174_neg <= unsigned(-setup_half_n172);
    setup_half_polar_angle_n174 <= setup_half_polar_angle_n174_neg when setup_half_n172(19) = '1' else unsigned(setup_half_n172);
    setup_half_polar_angle_n197 <= unsigned(setup_half_n172(19 downto 19));
    -- dot_l
    dot_l_n207 <= signed(resize(setup_light_phi_s14, 17)) - signed(resize(setup_phi_p_s14, 17));
    dot_l_delta <= unsigned(dot_l_n207(15 downto 0));
    -- dot_l.sincos
    dot_l_sincos_n209 <= dot_l_delta(15 downto 6);
    -- dot_h
    dot_h_n223 <= signed(resize(setup_half_phi_s14, 17)) - signed(resize(setup_phi_p_s14, 17));
    dot_h_delta <= unsigned(dot_h_n223(15 downto 0));
    -- dot_h.sincos
    dot_h_sincos_n225 <= dot_h_delta(15 downto 6);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_polar_angle_n83_s15 <= setup_light_polar_angle_n83_s14;
                setup_light_polar_angle_n84_s15 <= setup_light_polar_angle_n84;
                setup_light_polar_angle_n104_s15 <= setup_light_polar_angle_n104_s14;
                setup_light_polar_angle_n107_s15 <= setup_light_polar_angle_n107;
                setup_half_polar_angle_n173_s15 <= setup_half_polar_angle_n173_s14;
                setup_half_polar_angle_n174_s15 <= setup_half_polar_angle_n174;
                setup_half_polar_angle_n194_s15 <= setup_half_polar_angle_n194_s14;
                setup_half_polar_angle_n197_s15 <= setup_half_polar_angle_n197;
                sincos_row_8 <= sincos_rom_4(to_integer(dot_l_sincos_n209));
                dot_l_sincos_n215_s15 <= dot_l_sincos_n215_s14;
                dot_l_sincos_n216_s15 <= dot_l_sincos_n216_s14;
                sincos_row_9 <= sincos_rom_5(to_integer(dot_h_sincos_n225));
            end if;
            if rst = '1' then
                valid_s15 <= '0';
            elsif ce = '1' then
                valid_s15 <= valid_s14;
            end if;
        end if;
    end process;

    -- ---- stage 15 ----
    -- setup.light.polar_angle
    setup_light_polar_angle_n85 <= "1" when setup_light_polar_angle_n83_s15 < setup_light_polar_angle_n84_s15 else "0";
    setup_light_polar_angle_n86 <= setup_light_polar_angle_n84_s15 when setup_light_polar_angle_n85(0) = '1' else setup_light_polar_angle_n83_s15;
    setup_light_polar_angle_n87 <= setup_light_polar_angle_n83_s15 when setup_light_polar_angle_n85(0) = '1' else setup_light_polar_angle_n84_s15;
    setup_light_polar_angle_n88_padded <= setup_light_polar_angle_n86 & 12x"fff";
    setup_light_polar_angle_n88_skip16 <= "1" when setup_light_polar_angle_n88_padded(31 downto 16) = 16x"0000" else "0";
    setup_light_polar_angle_n88_part16 <= setup_light_polar_angle_n88_padded(15 downto 0) when setup_light_polar_angle_n88_skip16(0) = '1' else setup_light_polar_angle_n88_padded(31 downto 16);
    setup_light_polar_angle_n88_skip8 <= "1" when setup_light_polar_angle_n88_part16(15 downto 8) = 8x"00" else "0";
    setup_light_polar_angle_n88_part8 <= setup_light_polar_angle_n88_part16(7 downto 0) when setup_light_polar_angle_n88_skip8(0) = '1' else setup_light_polar_angle_n88_part16(15 downto 8);
    setup_light_polar_angle_n88_skip4 <= "1" when setup_light_polar_angle_n88_part8(7 downto 4) = 4x"0" else "0";
    setup_light_polar_angle_n88_part4 <= setup_light_polar_angle_n88_part8(3 downto 0) when setup_light_polar_angle_n88_skip4(0) = '1' else setup_light_polar_angle_n88_part8(7 downto 4);
    setup_light_polar_angle_n88_skip2 <= "1" when setup_light_polar_angle_n88_part4(3 downto 2) = "00" else "0";
    setup_light_polar_angle_n88_part2 <= setup_light_polar_angle_n88_part4(1 downto 0) when setup_light_polar_angle_n88_skip2(0) = '1' else setup_light_polar_angle_n88_part4(3 downto 2);
    setup_light_polar_angle_n88_skip1 <= "1" when setup_light_polar_angle_n88_part2(1 downto 1) = "0" else "0";
    setup_light_polar_angle_n88 <= setup_light_polar_angle_n88_skip16 & setup_light_polar_angle_n88_skip8 & setup_light_polar_angle_n88_skip4 & setup_light_polar_angle_n88_skip2 & setup_light_polar_angle_n88_skip1;
    -- setup.half.polar_angle
    setup_half_polar_angle_n175 <= "1" when setup_half_polar_angle_n173_s15 < setup_half_polar_angle_n174_s15 else "0";
    setup_half_polar_angle_n176 <= setup_half_polar_angle_n174_s15 when setup_half_polar_angle_n175(0) = '1' else setup_half_polar_angle_n173_s15;
    setup_half_polar_angle_n177 <= setup_half_polar_angle_n173_s15 when setup_half_polar_angle_n175(0) = '1' else setup_half_polar_angle_n174_s15;
    setup_half_polar_angle_n178_padded <= setup_half_polar_angle_n176 & 12x"fff";
    setup_half_polar_angle_n178_skip16 <= "1" when setup_half_polar_angle_n178_padded(31 downto 16) = 16x"0000" else "0";
    setup_half_polar_angle_n178_part16 <= setup_half_polar_angle_n178_padded(15 downto 0) when setup_half_polar_angle_n178_skip16(0) = '1' else setup_half_polar_angle_n178_padded(31 downto 16);
    setup_half_polar_angle_n178_skip8 <= "1" when setup_half_polar_angle_n178_part16(15 downto 8) = 8x"00" else "0";
    setup_half_polar_angle_n178_part8 <= setup_half_polar_angle_n178_part16(7 downto 0) when setup_half_polar_angle_n178_skip8(0) = '1' else setup_half_polar_angle_n178_part16(15 downto 8);
    setup_half_polar_angle_n178_skip4 <= "1" when setup_half_polar_angle_n178_part8(7 downto 4) = 4x"0" else "0";
    setup_half_polar_angle_n178_part4 <= setup_half_polar_angle_n178_part8(3 downto 0) when setup_half_polar_angle_n178_skip4(0) = '1' else setup_half_polar_angle_n178_part8(7 downto 4);
    setup_half_polar_angle_n178_skip2 <= "1" when setup_half_polar_angle_n178_part4(3 downto 2) = "00" else "0";
    setup_half_polar_angle_n178_part2 <= setup_half_polar_angle_n178_part4(1 downto 0) when setup_half_polar_angle_n178_skip2(0) = '1' else setup_half_polar_angle_n178_part4(3 downto 2);
    setup_half_polar_angle_n178_skip1 <= "1" when setup_half_polar_angle_n178_part2(1 downto 1) = "0" else "0";
    setup_half_polar_angle_n178 <= setup_half_polar_angle_n178_skip16 & setup_half_polar_angle_n178_skip8 & setup_half_polar_angle_n178_skip4 & setup_half_polar_angle_n178_skip2 & setup_half_polar_angle_n178_skip1;
    -- dot_l.sincos
    dot_l_sincos_n210 <= signed(sincos_row_8(19 downto 0));
    -- dot_h.sincos
    dot_h_sincos_n226 <= signed(sincos_row_9(19 downto 0));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_polar_angle_n85_s16 <= setup_light_polar_angle_n85;
                setup_light_polar_angle_n86_s16 <= setup_light_polar_angle_n86;
                setup_light_polar_angle_n87_s16 <= setup_light_polar_angle_n87;
                setup_light_polar_angle_n88_s16 <= setup_light_polar_angle_n88;
                setup_light_polar_angle_n104_s16 <= setup_light_polar_angle_n104_s15;
                setup_light_polar_angle_n107_s16 <= setup_light_polar_angle_n107_s15;
                setup_half_polar_angle_n175_s16 <= setup_half_polar_angle_n175;
                setup_half_polar_angle_n176_s16 <= setup_half_polar_angle_n176;
                setup_half_polar_angle_n177_s16 <= setup_half_polar_angle_n177;
                setup_half_polar_angle_n178_s16 <= setup_half_polar_angle_n178;
                setup_half_polar_angle_n194_s16 <= setup_half_polar_angle_n194_s15;
                setup_half_polar_angle_n197_s16 <= setup_half_polar_angle_n197_s15;
                dot_l_sincos_n210_s16 <= dot_l_sincos_n210;
                dot_l_sincos_n215_s16 <= dot_l_sincos_n215_s15;
                dot_l_sincos_n216_s16 <= dot_l_sincos_n216_s15;
                dot_h_sincos_n226_s16 <= dot_h_sincos_n226;
            end if;
            if rst = '1' then
                valid_s16 <= '0';
            elsif ce = '1' then
                valid_s16 <= valid_s15;
            end if;
        end if;
    end process;

    -- ---- stage 16 ----
    -- setup.light.polar_angle
    setup_light_polar_angle_n89_past <= "1" when 5x"14" < setup_light_polar_angle_n88_s16 else "0";
    setup_light_polar_angle_n89_count <= 5x"14" when setup_light_polar_angle_n89_past(0) = '1' else setup_light_polar_angle_n88_s16;
    setup_light_polar_angle_n89 <= shift_left(resize(setup_light_polar_angle_n86_s16, 40), to_integer(setup_light_polar_angle_n89_count));
    setup_light_polar_angle_n90 <= setup_light_polar_angle_n89(19 downto 0);
    setup_light_polar_angle_n91_past <= "1" when 5x"14" < setup_light_polar_angle_n88_s16 else "0";
    setup_light_polar_angle_n91_count <= 5x"14" when setup_light_polar_angle_n91_past(0) = '1' else setup_light_polar_angle_n88_s16;
    setup_light_polar_angle_n91 <= shift_left(resize(setup_light_polar_angle_n87_s16, 40), to_integer(setup_light_polar_angle_n91_count));
    setup_light_polar_angle_n92 <= setup_light_polar_angle_n91(19 downto 0);
    setup_light_polar_angle_n93 <= setup_light_polar_angle_n90(18 downto 0);
    setup_light_polar_angle_n94 <= setup_light_polar_angle_n93;
    -- setup.light.polar_angle.recip
    setup_light_polar_angle_recip_n95 <= setup_light_polar_angle_n94(18 downto 9);
    -- setup.light.polar_angle
    setup_light_polar_angle_n97 <= setup_light_polar_angle_n92;
    -- setup.half.polar_angle
    setup_half_polar_angle_n179_past <= "1" when 5x"14" < setup_half_polar_angle_n178_s16 else "0";
    setup_half_polar_angle_n179_count <= 5x"14" when setup_half_polar_angle_n179_past(0) = '1' else setup_half_polar_angle_n178_s16;
    setup_half_polar_angle_n179 <= shift_left(resize(setup_half_polar_angle_n176_s16, 40), to_integer(setup_half_polar_angle_n179_count));
    setup_half_polar_angle_n180 <= setup_half_polar_angle_n179(19 downto 0);
    setup_half_polar_angle_n181_past <= "1" when 5x"14" < setup_half_polar_angle_n178_s16 else "0";
    setup_half_polar_angle_n181_count <= 5x"14" when setup_half_polar_angle_n181_past(0) = '1' else setup_half_polar_angle_n178_s16;
    setup_half_polar_angle_n181 <= shift_left(resize(setup_half_polar_angle_n177_s16, 40), to_integer(setup_half_polar_angle_n181_count));
    setup_half_polar_angle_n182 <= setup_half_polar_angle_n181(19 downto 0);
    setup_half_polar_angle_n183 <= setup_half_polar_angle_n180(18 downto 0);
    setup_half_polar_angle_n184 <= setup_half_polar_angle_n183;
    -- setup.half.polar_angle.recip
    setup_half_polar_angle_recip_n185 <= setup_half_polar_angle_n184(18 downto 9);
    -- setup.half.polar_angle
    setup_half_polar_angle_n187 <= setup_half_polar_angle_n182;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_polar_angle_n85_s17 <= setup_light_polar_angle_n85_s16;
                recip_row_3 <= recip_rom_2(to_integer(setup_light_polar_angle_recip_n95));
                setup_light_polar_angle_n97_s17 <= setup_light_polar_angle_n97;
                setup_light_polar_angle_n104_s17 <= setup_light_polar_angle_n104_s16;
                setup_light_polar_angle_n107_s17 <= setup_light_polar_angle_n107_s16;
                setup_half_polar_angle_n175_s17 <= setup_half_polar_angle_n175_s16;
                recip_row_4 <= recip_rom_2(to_integer(setup_half_polar_angle_recip_n185));
                setup_half_polar_angle_n187_s17 <= setup_half_polar_angle_n187;
                setup_half_polar_angle_n194_s17 <= setup_half_polar_angle_n194_s16;
                setup_half_polar_angle_n197_s17 <= setup_half_polar_angle_n197_s16;
                dot_l_sincos_n210_s17 <= dot_l_sincos_n210_s16;
                dot_l_sincos_n215_s17 <= dot_l_sincos_n215_s16;
                dot_l_sincos_n216_s17 <= dot_l_sincos_n216_s16;
                dot_h_sincos_n226_s17 <= dot_h_sincos_n226_s16;
            end if;
            if rst = '1' then
                valid_s17 <= '0';
            elsif ce = '1' then
                valid_s17 <= valid_s16;
            end if;
        end if;
    end process;

    -- ---- stage 17 ----
    -- setup.light.polar_angle.recip
    setup_light_polar_angle_recip_n96 <= recip_row_3;
    -- setup.half.polar_angle.recip
    setup_half_polar_angle_recip_n186 <= recip_row_4;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_polar_angle_n85_s18 <= setup_light_polar_angle_n85_s17;
                setup_light_polar_angle_recip_n96_s18 <= setup_light_polar_angle_recip_n96;
                setup_light_polar_angle_n97_s18 <= setup_light_polar_angle_n97_s17;
                setup_light_polar_angle_n104_s18 <= setup_light_polar_angle_n104_s17;
                setup_light_polar_angle_n107_s18 <= setup_light_polar_angle_n107_s17;
                setup_half_polar_angle_n175_s18 <= setup_half_polar_angle_n175_s17;
                setup_half_polar_angle_recip_n186_s18 <= setup_half_polar_angle_recip_n186;
                setup_half_polar_angle_n187_s18 <= setup_half_polar_angle_n187_s17;
                setup_half_polar_angle_n194_s18 <= setup_half_polar_angle_n194_s17;
                setup_half_polar_angle_n197_s18 <= setup_half_polar_angle_n197_s17;
                dot_l_sincos_n210_s18 <= dot_l_sincos_n210_s17;
                dot_l_sincos_n215_s18 <= dot_l_sincos_n215_s17;
                dot_l_sincos_n216_s18 <= dot_l_sincos_n216_s17;
                dot_h_sincos_n226_s18 <= dot_h_sincos_n226_s17;
            end if;
            if rst = '1' then
                valid_s18 <= '0';
            elsif ce = '1' then
                valid_s18 <= valid_s17;
            end if;
        end if;
    end process;

    -- ---- stage 18 ----
    -- setup.light.polar_angle
    setup_light_polar_angle_n98 <= setup_light_polar_angle_n97_s18 * setup_light_polar_angle_recip_n96_s18;
    -- setup.half.polar_angle
    setup_half_polar_angle_n188 <= setup_half_polar_angle_n187_s18 * setup_half_polar_angle_recip_n186_s18;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_polar_angle_n85_s19 <= setup_light_polar_angle_n85_s18;
                setup_light_polar_angle_n98_s19 <= setup_light_polar_angle_n98;
                setup_light_polar_angle_n104_s19 <= setup_light_polar_angle_n104_s18;
                setup_light_polar_angle_n107_s19 <= setup_light_polar_angle_n107_s18;
                setup_half_polar_angle_n175_s19 <= setup_half_polar_angle_n175_s18;
                setup_half_polar_angle_n188_s19 <= setup_half_polar_angle_n188;
                setup_half_polar_angle_n194_s19 <= setup_half_polar_angle_n194_s18;
                setup_half_polar_angle_n197_s19 <= setup_half_polar_angle_n197_s18;
                dot_l_sincos_n210_s19 <= dot_l_sincos_n210_s18;
                dot_l_sincos_n215_s19 <= dot_l_sincos_n215_s18;
                dot_l_sincos_n216_s19 <= dot_l_sincos_n216_s18;
                dot_h_sincos_n226_s19 <= dot_h_sincos_n226_s18;
            end if;
            if rst = '1' then
                valid_s19 <= '0';
            elsif ce = '1' then
                valid_s19 <= valid_s18;
            end if;
        end if;
    end process;

    -- ---- stage 19 ----
    -- setup.light.polar_angle
    setup_light_polar_angle_ratio_sum <= resize(setup_light_polar_angle_n98_s19, 41) + 41x"00000080000";
    setup_light_polar_angle_ratio_cut <= setup_light_polar_angle_ratio_sum(40 downto 20);
    setup_light_polar_angle_ratio_over <= "1" when (or setup_light_polar_angle_ratio_cut(20 downto 18)) = '1' else "0";
    setup_light_polar_angle_ratio <= 18x"3ffff" when setup_light_polar_angle_ratio_over(0) = '1' else setup_light_polar_angle_ratio_cut(17 downto 0);
    -- setup.light.polar_angle.atan
    setup_light_polar_angle_atan_n100 <= setup_light_polar_angle_ratio(17 downto 8);
    -- setup.half.polar_angle
    setup_half_polar_angle_ratio_sum <= resize(setup_half_polar_angle_n188_s19, 41) + 41x"00000080000";
    setup_half_polar_angle_ratio_cut <= setup_half_polar_angle_ratio_sum(40 downto 20);
    setup_half_polar_angle_ratio_over <= "1" when (or setup_half_polar_angle_ratio_cut(20 downto 18)) = '1' else "0";
    setup_half_polar_angle_ratio <= 18x"3ffff" when setup_half_polar_angle_ratio_over(0) = '1' else setup_half_polar_angle_ratio_cut(17 downto 0);
    -- setup.half.polar_angle.atan
    setup_half_polar_angle_atan_n190 <= setup_half_polar_angle_ratio(17 downto 8);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_polar_angle_n85_s20 <= setup_light_polar_angle_n85_s19;
                atan_row_3 <= atan_rom_2(to_integer(setup_light_polar_angle_atan_n100));
                setup_light_polar_angle_n104_s20 <= setup_light_polar_angle_n104_s19;
                setup_light_polar_angle_n107_s20 <= setup_light_polar_angle_n107_s19;
                setup_half_polar_angle_n175_s20 <= setup_half_polar_angle_n175_s19;
                atan_row_4 <= atan_rom_2(to_integer(setup_half_polar_angle_atan_n190));
                setup_half_polar_angle_n194_s20 <= setup_half_polar_angle_n194_s19;
                setup_half_polar_angle_n197_s20 <= setup_half_polar_angle_n197_s19;
                dot_l_sincos_n210_s20 <= dot_l_sincos_n210_s19;
                dot_l_sincos_n215_s20 <= dot_l_sincos_n215_s19;
                dot_l_sincos_n216_s20 <= dot_l_sincos_n216_s19;
                dot_h_sincos_n226_s20 <= dot_h_sincos_n226_s19;
            end if;
            if rst = '1' then
                valid_s20 <= '0';
            elsif ce = '1' then
                valid_s20 <= valid_s19;
            end if;
        end if;
    end process;

    -- ---- stage 20 ----
    -- setup.light.polar_angle.atan
    setup_light_polar_angle_atan_n101 <= atan_row_3(37 downto 19);
    -- setup.light.polar_angle
    setup_light_polar_angle_n102 <= signed(resize(setup_light_azimuth_n69, 20)) - signed(resize(setup_light_polar_angle_atan_n101, 20));
    setup_light_polar_angle_n103 <= setup_light_polar_angle_n102 when setup_light_polar_angle_n85_s20(0) = '1' else signed(resize(setup_light_polar_angle_atan_n101, 20));
    -- setup.half.polar_angle.atan
    setup_half_polar_angle_atan_n191 <= atan_row_4(37 downto 19);
    -- setup.half.polar_angle
    setup_half_polar_angle_n192 <= signed(resize(setup_light_azimuth_n69, 20)) - signed(resize(setup_half_polar_angle_atan_n191, 20));
    setup_half_polar_angle_n193 <= setup_half_polar_angle_n192 when setup_half_polar_angle_n175_s20(0) = '1' else signed(resize(setup_half_polar_angle_atan_n191, 20));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_polar_angle_n103_s21 <= setup_light_polar_angle_n103;
                setup_light_polar_angle_n104_s21 <= setup_light_polar_angle_n104_s20;
                setup_light_polar_angle_n107_s21 <= setup_light_polar_angle_n107_s20;
                setup_half_polar_angle_n193_s21 <= setup_half_polar_angle_n193;
                setup_half_polar_angle_n194_s21 <= setup_half_polar_angle_n194_s20;
                setup_half_polar_angle_n197_s21 <= setup_half_polar_angle_n197_s20;
                dot_l_sincos_n210_s21 <= dot_l_sincos_n210_s20;
                dot_l_sincos_n215_s21 <= dot_l_sincos_n215_s20;
                dot_l_sincos_n216_s21 <= dot_l_sincos_n216_s20;
                dot_h_sincos_n226_s21 <= dot_h_sincos_n226_s20;
            end if;
            if rst = '1' then
                valid_s21 <= '0';
            elsif ce = '1' then
                valid_s21 <= valid_s20;
            end if;
        end if;
    end process;

    -- ---- stage 21 ----
    -- setup.light.polar_angle
    setup_light_polar_angle_n105 <= signed(resize(setup_light_azimuth_n73, 21)) - resize(setup_light_polar_angle_n103_s21, 21);
    setup_light_polar_angle_n106 <= setup_light_polar_angle_n105 when setup_light_polar_angle_n104_s21(0) = '1' else resize(setup_light_polar_angle_n103_s21, 21);
    setup_light_polar_angle_n108 <= -resize(setup_light_polar_angle_n106, 22);
    setup_light_polar_angle_n109 <= setup_light_polar_angle_n108 when setup_light_polar_angle_n107_s21(0) = '1' else resize(setup_light_polar_angle_n106, 22);
    setup_light_polar_angle_n110 <= unsigned(setup_light_polar_angle_n109(17 downto 0));
    -- setup.light
    setup_light_n113_sum <= resize(setup_light_polar_angle_n110, 19) + 19x"00002";
    setup_light_n113_cut <= setup_light_n113_sum(18 downto 2);
    setup_light_n113 <= setup_light_n113_cut;
    setup_light_theta <= setup_light_n113(15 downto 0);
    -- setup.half.polar_angle
    setup_half_polar_angle_n195 <= signed(resize(setup_light_azimuth_n73, 21)) - resize(setup_half_polar_angle_n193_s21, 21);
    setup_half_polar_angle_n196 <= setup_half_polar_angle_n195 when setup_half_polar_angle_n194_s21(0) = '1' else resize(setup_half_polar_angle_n193_s21, 21);
    setup_half_polar_angle_n198 <= -resize(setup_half_polar_angle_n196, 22);
    setup_half_polar_angle_n199 <= setup_half_polar_angle_n198 when setup_half_polar_angle_n197_s21(0) = '1' else resize(setup_half_polar_angle_n196, 22);
    setup_half_polar_angle_n200 <= unsigned(setup_half_polar_angle_n199(17 downto 0));
    -- setup.half
    setup_half_n203_sum <= resize(setup_half_polar_angle_n200, 19) + 19x"00002";
    setup_half_n203_cut <= setup_half_n203_sum(18 downto 2);
    setup_half_n203 <= setup_half_n203_cut;
    setup_half_theta <= setup_half_n203(15 downto 0);
    -- dot_l.sincos
    dot_l_sincos_n211 <= setup_light_theta(15 downto 6);
    -- dot_h.sincos
    dot_h_sincos_n227 <= setup_half_theta(15 downto 6);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                dot_l_sincos_n210_s22 <= dot_l_sincos_n210_s21;
                dot_l_sincos_n211_s22 <= dot_l_sincos_n211;
                dot_l_sincos_n215_s22 <= dot_l_sincos_n215_s21;
                dot_l_sincos_n216_s22 <= dot_l_sincos_n216_s21;
                dot_h_sincos_n226_s22 <= dot_h_sincos_n226_s21;
                dot_h_sincos_n227_s22 <= dot_h_sincos_n227;
            end if;
            if rst = '1' then
                valid_s22 <= '0';
            elsif ce = '1' then
                valid_s22 <= valid_s21;
            end if;
        end if;
    end process;

    -- ---- stage 22 ----

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                dot_l_sincos_n210_s23 <= dot_l_sincos_n210_s22;
                sincos_row_10 <= sincos_rom_5(to_integer(dot_l_sincos_n211_s22));
                dot_l_sincos_n215_s23 <= dot_l_sincos_n215_s22;
                dot_l_sincos_n216_s23 <= dot_l_sincos_n216_s22;
                dot_h_sincos_n226_s23 <= dot_h_sincos_n226_s22;
                sincos_row_11 <= sincos_rom_6(to_integer(dot_h_sincos_n227_s22));
            end if;
            if rst = '1' then
                valid_s23 <= '0';
            elsif ce = '1' then
                valid_s23 <= valid_s22;
            end if;
        end if;
    end process;

    -- ---- stage 23 ----
    -- dot_l.sincos
    dot_l_sincos_n212 <= signed(sincos_row_10(39 downto 20));
    dot_l_sincos_n213 <= signed(sincos_row_10(19 downto 0));
    -- dot_h.sincos
    dot_h_sincos_n228 <= signed(sincos_row_11(39 downto 20));
    dot_h_sincos_n229 <= signed(sincos_row_11(19 downto 0));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                dot_l_sincos_n210_s24 <= dot_l_sincos_n210_s23;
                dot_l_sincos_n212_s24 <= dot_l_sincos_n212;
                dot_l_sincos_n213_s24 <= dot_l_sincos_n213;
                dot_l_sincos_n215_s24 <= dot_l_sincos_n215_s23;
                dot_l_sincos_n216_s24 <= dot_l_sincos_n216_s23;
                dot_h_sincos_n226_s24 <= dot_h_sincos_n226_s23;
                dot_h_sincos_n228_s24 <= dot_h_sincos_n228;
                dot_h_sincos_n229_s24 <= dot_h_sincos_n229;
            end if;
            if rst = '1' then
                valid_s24 <= '0';
            elsif ce = '1' then
                valid_s24 <= valid_s23;
            end if;
        end if;
    end process;

    -- ---- stage 24 ----
    -- dot_l
    dot_l_n217 <= dot_l_sincos_n213_s24 * dot_l_sincos_n216_s24;
    dot_l_n218 <= dot_l_sincos_n212_s24 * dot_l_sincos_n215_s24;
    -- dot_h
    dot_h_n230 <= dot_h_sincos_n229_s24 * dot_l_sincos_n216_s24;
    dot_h_n231 <= dot_h_sincos_n228_s24 * dot_l_sincos_n215_s24;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                dot_l_sincos_n210_s25 <= dot_l_sincos_n210_s24;
                dot_l_n217_s25 <= dot_l_n217;
                dot_l_n218_s25 <= dot_l_n218;
                dot_h_sincos_n226_s25 <= dot_h_sincos_n226_s24;
                dot_h_n230_s25 <= dot_h_n230;
                dot_h_n231_s25 <= dot_h_n231;
            end if;
            if rst = '1' then
                valid_s25 <= '0';
            elsif ce = '1' then
                valid_s25 <= valid_s24;
            end if;
        end if;
    end process;

    -- ---- stage 25 ----
    -- dot_l
    dot_l_n219_sum <= resize(dot_l_n218_s25, 41) + 41x"00000020000";
    dot_l_n219_cut <= dot_l_n219_sum(40 downto 18);
    dot_l_n219_over <= "1" when dot_l_n219_cut(22) = '0' and (or dot_l_n219_cut(21 downto 20)) = '1' else "0";
    dot_l_n219_under <= "1" when dot_l_n219_cut(22) = '1' and (and dot_l_n219_cut(21 downto 20)) = '0' else "0";
    dot_l_n219 <= 21x"0fffff" when dot_l_n219_over(0) = '1' else 21x"100000" when dot_l_n219_under(0) = '1' else dot_l_n219_cut(20 downto 0);
    -- dot_h
    dot_h_n232_sum <= resize(dot_h_n231_s25, 41) + 41x"00000020000";
    dot_h_n232_cut <= dot_h_n232_sum(40 downto 18);
    dot_h_n232_over <= "1" when dot_h_n232_cut(22) = '0' and (or dot_h_n232_cut(21 downto 20)) = '1' else "0";
    dot_h_n232_under <= "1" when dot_h_n232_cut(22) = '1' and (and dot_h_n232_cut(21 downto 20)) = '0' else "0";
    dot_h_n232 <= 21x"0fffff" when dot_h_n232_over(0) = '1' else 21x"100000" when dot_h_n232_under(0) = '1' else dot_h_n232_cut(20 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                dot_l_sincos_n210_s26 <= dot_l_sincos_n210_s25;
                dot_l_n217_s26 <= dot_l_n217_s25;
                dot_l_n219_s26 <= dot_l_n219;
                dot_h_sincos_n226_s26 <= dot_h_sincos_n226_s25;
                dot_h_n230_s26 <= dot_h_n230_s25;
                dot_h_n232_s26 <= dot_h_n232;
            end if;
            if rst = '1' then
                valid_s26 <= '0';
            elsif ce = '1' then
                valid_s26 <= valid_s25;
            end if;
        end if;
    end process;

    -- ---- stage 26 ----
    -- dot_l
    dot_l_n220 <= dot_l_n219_s26 * dot_l_sincos_n210_s26;
    -- dot_h
    dot_h_n233 <= dot_h_n232_s26 * dot_h_sincos_n226_s26;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                dot_l_n217_s27 <= dot_l_n217_s26;
                dot_l_n220_s27 <= dot_l_n220;
                dot_h_n230_s27 <= dot_h_n230_s26;
                dot_h_n233_s27 <= dot_h_n233;
            end if;
            if rst = '1' then
                valid_s27 <= '0';
            elsif ce = '1' then
                valid_s27 <= valid_s26;
            end if;
        end if;
    end process;

    -- ---- stage 27 ----
    -- dot_l
    dot_l_n221 <= resize(dot_l_n217_s27, 42) + resize(dot_l_n220_s27, 42);
    -- (unit)
    dot_l_sum <= resize(dot_l_n221, 43) + 43x"00000080000";
    dot_l_cut <= dot_l_sum(42 downto 20);
    dot_l_over <= "1" when dot_l_cut(22) = '0' and (or dot_l_cut(21 downto 17)) = '1' else "0";
    dot_l_under <= "1" when dot_l_cut(22) = '1' and (and dot_l_cut(21 downto 17)) = '0' else "0";
    dot_l <= 18x"1ffff" when dot_l_over(0) = '1' else 18x"20000" when dot_l_under(0) = '1' else dot_l_cut(17 downto 0);
    -- dot_h
    dot_h_n234 <= resize(dot_h_n230_s27, 42) + resize(dot_h_n233_s27, 42);
    -- (unit)
    dot_h_sum <= resize(dot_h_n234, 43) + 43x"00000080000";
    dot_h_cut <= dot_h_sum(42 downto 20);
    dot_h_over <= "1" when dot_h_cut(22) = '0' and (or dot_h_cut(21 downto 17)) = '1' else "0";
    dot_h_under <= "1" when dot_h_cut(22) = '1' and (and dot_h_cut(21 downto 17)) = '0' else "0";
    dot_h <= 18x"1ffff" when dot_h_over(0) = '1' else 18x"20000" when dot_h_under(0) = '1' else dot_h_cut(17 downto 0);
    n237 <= unsigned(dot_l(17 downto 17));
    n238 <= signed(shift_left(resize(n236, 18), 16)) when n237(0) = '1' else dot_l;
    diffuse_index_under <= unsigned(n238(17 downto 17));
    diffuse_index <= 17x"00000" when diffuse_index_under(0) = '1' else unsigned(n238(16 downto 0));
    n240 <= diffuse_index(16 downto 16);
    n241 <= diffuse_index(15 downto 0);
    n242 <= n241;
    -- diffuse
    diffuse_n243 <= n242(15 downto 6);
    -- (unit)
    n249 <= unsigned(dot_h(17 downto 17));
    n250 <= signed(shift_left(resize(n236, 18), 16)) when n249(0) = '1' else dot_h;
    specular_index_under <= unsigned(n250(17 downto 17));
    specular_index <= 17x"00000" when specular_index_under(0) = '1' else unsigned(n250(16 downto 0));
    n252 <= specular_index(16 downto 16);
    n253 <= specular_index(15 downto 0);
    n254 <= n253;
    -- specular
    specular_n255 <= n254(15 downto 6);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                n237_s28 <= n237;
                n240_s28 <= n240;
                diffuse_n243_s28 <= diffuse_n243;
                n249_s28 <= n249;
                n252_s28 <= n252;
                specular_n255_s28 <= specular_n255;
            end if;
            if rst = '1' then
                valid_s28 <= '0';
            elsif ce = '1' then
                valid_s28 <= valid_s27;
            end if;
        end if;
    end process;

    -- ---- stage 28 ----

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                n237_s29 <= n237_s28;
                n240_s29 <= n240_s28;
                diffuse_row <= diffuse_rom(to_integer(diffuse_n243_s28));
                n249_s29 <= n249_s28;
                n252_s29 <= n252_s28;
                specular_row <= specular_rom(to_integer(specular_n255_s28));
            end if;
            if rst = '1' then
                valid_s29 <= '0';
            elsif ce = '1' then
                valid_s29 <= valid_s28;
            end if;
        end if;
    end process;

    -- ---- stage 29 ----
    -- diffuse
    diffuse_n244 <= diffuse_row;
    -- (unit)
    n247 <= n245 when n240_s29(0) = '1' else diffuse_n244;
    diffuse_next <= n246 when n237_s29(0) = '1' else n247;
    -- specular
    specular_n256 <= specular_row;
    -- (unit)
    n259 <= n257 when n252_s29(0) = '1' else specular_n256;
    specular_next <= n258 when n249_s29(0) = '1' else n259;
    n261 <= resize(diffuse_next, 17) + resize(specular_next, 17);
    intensity_next_over <= "1" when (or n261(16 downto 16)) = '1' else "0";
    intensity_next <= 16x"ffff" when intensity_next_over(0) = '1' else n261(15 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                diffuse <= diffuse_next;
                specular <= specular_next;
                intensity <= intensity_next;
            end if;
            if rst = '1' then
                valid_s30 <= '0';
            elsif ce = '1' then
                valid_s30 <= valid_s29;
            end if;
        end if;
    end process;

    -- ---- stage 30 ----

    valid_out <= valid_s30;
end architecture;
