-- tangent: tangent-space set-up of a triangle's vertex: map, view vector and lights in texture space
-- made by fixpath 0.1.0; seed 004 (US 7,843,463), with its mirroring rule and facets as printed and mended
--   frame=faceted mirror=handed basis=orthonormal lights=1 position_int_bits=4
--   position_frac_bits=11 uv_int_bits=2 uv_frac_bits=13 component_bits=16 guard_bits=2
--   vector_int_bits=1 vector_bits=16 out_frac_bits=14 norm_bits=18 dot_frac_bits=20
--   root_scheme=linear root_addr_bits=8 root_frac_bits=18 rounding=half-up period_ps=5000
--   stages=auto rom=block
-- latency 21 cycles, interval 1 cycle; tables read on the clock
-- absolute errors against the golden of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst:
--   t_angle: mean 6.48e-6 rad, at most 1.96e-5 rad at p0_x=17354 p0_y=8360 p0_z=19876 p1_x=12416 p1_y=2144 p1_z=6776 p2_x=6288 p2_y=7448 p2_z=26840 uv0_u=-11814 uv0_v=-11791 uv1_u=-11843 uv1_v=-11706 uv2_u=-11757 uv2_v=-11667 view_x=-578 view_y=-3659 view_z=1930 light0_x=3235 light0_y=7280 light0_z=8272
--   t_dot: mean 8.62e-6, at most 2.31e-5 at p0_x=-3977 p0_y=-2247 p0_z=12757 p1_x=-7571 p1_y=-7658 p1_z=12820 p2_x=156 p2_y=-4587 p2_z=10504 uv0_u=9002 uv0_v=13737 uv1_u=9046 uv1_v=13793 uv2_u=9051 uv2_v=13663 view_x=-1267 view_y=4021 view_z=-333 light0_x=389 light0_y=-3071 light0_z=2715
--   t_x: mean 4.40e-6, at most 1.97e-5 (1.3 ulp) at p0_x=9284 p0_y=-3493 p0_z=-3736 p1_x=9160 p1_y=-3452 p1_z=-3609 p2_x=9019 p2_y=-3386 p2_z=-3771 uv0_u=-16367 uv0_v=-7717 uv1_u=-13327 uv1_v=-5585 uv2_u=-18661 uv2_v=-10805 view_x=-5671 view_y=-8782 view_z=-1494 light0_x=-3709 light0_y=-8505 light0_z=6138
--   t_y: mean 4.40e-6, at most 1.96e-5 (1.3 ulp) at p0_x=3279 p0_y=8679 p0_z=-15980 p1_x=2427 p1_y=8671 p1_z=-15309 p2_x=2885 p2_y=8087 p2_z=-15477 uv0_u=-13104 uv0_v=-4401 uv1_u=-14609 uv1_v=-7850 uv2_u=-15592 uv2_v=-6185 view_x=3937 view_y=-16021 view_z=6330 light0_x=297 light0_y=9264 light0_z=-17765
--   t_z: mean 4.38e-6, at most 2.01e-5 (1.3 ulp) at p0_x=-8725 p0_y=14727 p0_z=13006 p1_x=-8699 p1_y=14847 p1_z=12986 p2_x=-8743 p2_y=14816 p2_z=13059 uv0_u=939 uv0_v=-2961 uv1_u=-1521 uv1_v=-6402 uv2_u=1418 uv2_v=-5400 view_x=-1506 view_y=3177 view_z=3849 light0_x=14610 light0_y=-7690 light0_z=-621
--   b_angle: mean 8.45e-6 rad, at most 2.69e-5 rad at p0_x=4185 p0_y=7298 p0_z=5131 p1_x=5334 p1_y=10722 p1_z=2325 p2_x=9456 p2_y=8256 p2_z=4578 uv0_u=-6024 uv0_v=-2922 uv1_u=-5129 uv1_v=-3864 uv2_u=-4903 uv2_v=-2852 view_x=-31824 view_y=3119 view_z=-5355 light0_x=16649 light0_y=-8093 light0_z=7604
--   b_dot: mean 1.24e-5, at most 4.13e-5 at p0_x=2727 p0_y=-15657 p0_z=-1825 p1_x=2139 p1_y=-13562 p1_z=-2014 p2_x=1581 p2_y=-15644 p2_z=-3682 uv0_u=-14348 uv0_v=-2260 uv1_u=-14803 uv1_v=-1795 uv2_u=-13838 uv2_v=-1973 view_x=4453 view_y=1001 view_z=-845 light0_x=-1055 light0_y=3371 light0_z=8300
--   b_x: mean 6.24e-6, at most 3.38e-5 (2.2 ulp) at p0_x=-9895 p0_y=1127 p0_z=8564 p1_x=-5361 p1_y=-5195 p1_z=-2305 p2_x=-4941 p2_y=2729 p2_z=9830 uv0_u=4016 uv0_v=-13259 uv1_u=4394 uv1_v=-13444 uv2_u=4313 uv2_v=-13581 view_x=-1478 view_y=8678 view_z=540 light0_x=-4528 light0_y=-5963 light0_z=19418
--   b_y: mean 6.23e-6, at most 3.39e-5 (2.2 ulp) at p0_x=-15019 p0_y=9014 p0_z=-13295 p1_x=-14507 p1_y=8933 p1_z=-12869 p2_x=-14987 p2_y=8562 p2_z=-13317 uv0_u=-14881 uv0_v=15595 uv1_u=-14823 uv1_v=15588 uv2_u=-14894 uv2_v=15693 view_x=2866 view_y=-4790 view_z=4016 light0_x=9546 light0_y=-921 light0_z=-8693
--   b_z: mean 6.24e-6, at most 3.48e-5 (2.3 ulp) at p0_x=-3692 p0_y=8154 p0_z=-10601 p1_x=-3711 p1_y=7749 p1_z=-10993 p2_x=-3945 p2_y=8012 p2_z=-10163 uv0_u=1555 uv0_v=-2538 uv1_u=1241 uv1_v=-2775 uv2_u=1226 uv2_v=-2342 view_x=6019 view_y=4765 view_z=1213 light0_x=-15436 light0_y=-2902 light0_z=13127
--   n_angle: mean 6.35e-6 rad, at most 2.11e-5 rad at p0_x=-8525 p0_y=5610 p0_z=14302 p1_x=-7985 p1_y=5335 p1_z=14453 p2_x=-8307 p2_y=6017 p2_z=14413 uv0_u=-14033 uv0_v=10384 uv1_u=-14566 uv1_v=9742 uv2_u=-15380 uv2_v=9625 view_x=-4112 view_y=4 view_z=465 light0_x=-4351 light0_y=-1403 light0_z=6776
--   n_dot: mean 8.50e-6, at most 2.54e-5 at p0_x=5670 p0_y=-1432 p0_z=-9760 p1_x=6211 p1_y=-2614 p1_z=-10342 p2_x=5615 p2_y=-1477 p2_z=-10166 uv0_u=6046 uv0_v=-13851 uv1_u=6205 uv1_v=-13667 uv2_u=6116 uv2_v=-13752 view_x=-5628 view_y=-10551 view_z=1846 light0_x=-2820 light0_y=3776 light0_z=-729
--   n_x: mean 4.32e-6, at most 1.97e-5 (1.3 ulp) at p0_x=-5587 p0_y=-9777 p0_z=-4927 p1_x=-5685 p1_y=-10675 p1_z=-13686 p2_x=-7131 p2_y=-14045 p2_z=-11875 uv0_u=18660 uv0_v=5079 uv1_u=18028 uv1_v=6508 uv2_u=15304 uv2_v=3518 view_x=10808 view_y=13351 view_z=-12460 light0_x=-2302 light0_y=585 light0_z=5071
--   n_y: mean 4.33e-6, at most 1.99e-5 (1.3 ulp) at p0_x=-10042 p0_y=-1339 p0_z=-3039 p1_x=-9952 p1_y=-1055 p1_z=-3726 p2_x=-10343 p2_y=-1458 p2_z=-3187 uv0_u=-7735 uv0_v=3129 uv1_u=-9856 uv1_v=147 uv2_u=-5085 uv2_v=6386 view_x=4704 view_y=-870 view_z=-148 light0_x=-1652 light0_y=8593 light0_z=26892
--   n_z: mean 4.35e-6, at most 1.97e-5 (1.3 ulp) at p0_x=14877 p0_y=-20515 p0_z=-17729 p1_x=14758 p1_y=543 p1_z=-10852 p2_x=2720 p2_y=3217 p2_z=-6578 uv0_u=-16018 uv0_v=-4401 uv1_u=-8707 uv1_v=3321 uv2_u=-11736 uv2_v=2209 view_x=8990 view_y=-905 view_z=2405 light0_x=1272 light0_y=-3105 light0_z=3092
--   ts_view_angle: mean 3.95e-5 rad, at most 2.00e-4 rad at p0_x=-15816 p0_y=1594 p0_z=-5449 p1_x=-9136 p1_y=-967 p1_z=-9324 p2_x=-8817 p2_y=7877 p2_z=-10436 uv0_u=-3252 uv0_v=-1882 uv1_u=-3334 uv1_v=-2003 uv2_u=-3218 uv2_v=-1654 view_x=489 view_y=3026 view_z=-2754 light0_x=4389 light0_y=-1970 light0_z=-4583
--   ts_view_dot: mean 3.07e-5, at most 8.46e-5 at p0_x=14650 p0_y=5324 p0_z=-11359 p1_x=14934 p1_y=5318 p1_z=-11666 p2_x=14912 p2_y=5480 p2_z=-11532 uv0_u=-16511 uv0_v=1868 uv1_u=-12104 uv1_v=-4 uv2_u=-13683 uv2_v=-1262 view_x=-5426 view_y=-31528 view_z=-4848 light0_x=-6143 light0_y=-4864 light0_z=-5443
--   ts_view_x: mean 1.57e-5, at most 5.88e-5 (1.0 ulp) at p0_x=5878 p0_y=7518 p0_z=16795 p1_x=5739 p1_y=12805 p1_z=18195 p2_x=5657 p2_y=7023 p2_z=13923 uv0_u=4015 uv0_v=-9102 uv1_u=3078 uv1_v=-9754 uv2_u=453 uv2_v=-9180 view_x=7735 view_y=-14355 view_z=-23535 light0_x=-2007 light0_y=-4241 light0_z=4390
--   ts_view_y: mean 1.62e-5, at most 7.65e-5 (1.3 ulp) at p0_x=-15315 p0_y=-5364 p0_z=-7467 p1_x=-15280 p1_y=-5299 p1_z=-7428 p2_x=-15302 p2_y=-5390 p2_z=-7483 uv0_u=-14473 uv0_v=4154 uv1_u=-16381 uv1_v=3415 uv2_u=-14957 uv2_v=4258 view_x=15606 view_y=25390 view_z=8391 light0_x=-4073 light0_y=1815 light0_z=2848
--   ts_view_z: mean 1.57e-5, at most 6.11e-5 (1.0 ulp) at p0_x=2993 p0_y=-1901 p0_z=-15333 p1_x=2596 p1_y=-1843 p1_z=-15320 p2_x=2677 p2_y=-1826 p2_z=-15494 uv0_u=-12722 uv0_v=8038 uv1_u=-12488 uv1_v=6556 uv2_u=-11750 uv2_v=6793 view_x=-14610 view_y=27993 view_z=7804 light0_x=2639 light0_y=7019 light0_z=-6813
--   ts_light0_angle: mean 3.95e-5 rad, at most 2.02e-4 rad at p0_x=-14877 p0_y=-12093 p0_z=10707 p1_x=-14855 p1_y=-13082 p1_z=11444 p2_x=-15811 p2_y=-13450 p2_z=12922 uv0_u=-6384 uv0_v=11918 uv1_u=-7618 uv1_v=14629 uv2_u=-6954 uv2_v=12881 view_x=-4883 view_y=3104 view_z=4535 light0_x=3630 light0_y=-372 light0_z=1907
--   ts_light0_dot: mean 3.07e-5, at most 7.62e-5 at p0_x=-5249 p0_y=1656 p0_z=-8042 p1_x=-5147 p1_y=1461 p1_z=-7922 p2_x=-4034 p2_y=2058 p2_z=-8565 uv0_u=-16871 uv0_v=7696 uv1_u=-16727 uv1_v=8704 uv2_u=-17083 uv2_v=7924 view_x=13448 view_y=7249 view_z=23744 light0_x=24517 light0_y=13885 light0_z=-4514
--   ts_light0_x: mean 1.57e-5, at most 6.33e-5 (1.0 ulp) at p0_x=-5836 p0_y=3280 p0_z=3011 p1_x=-5771 p1_y=6594 p1_z=6951 p2_x=-7742 p2_y=6237 p2_z=2998 uv0_u=-5577 uv0_v=-8593 uv1_u=-5536 uv1_v=-8633 uv2_u=-5220 uv2_v=-8711 view_x=-4235 view_y=8857 view_z=16296 light0_x=685 light0_y=12183 light0_z=27317
--   ts_light0_y: mean 1.62e-5, at most 7.48e-5 (1.2 ulp) at p0_x=11802 p0_y=-7858 p0_z=4797 p1_x=12464 p1_y=-8360 p1_z=2055 p2_x=14542 p2_y=-8593 p2_z=6048 uv0_u=6880 uv0_v=-5961 uv1_u=6256 uv1_v=-5671 uv2_u=7430 uv2_v=-3745 view_x=3647 view_y=2488 view_z=-1186 light0_x=-29774 light0_y=7315 light0_z=1107
--   ts_light0_z: mean 1.57e-5, at most 6.10e-5 (1.0 ulp) at p0_x=4679 p0_y=2416 p0_z=-2219 p1_x=4733 p1_y=2362 p1_z=-2206 p2_x=4771 p2_y=2354 p2_z=-2255 uv0_u=-12814 uv0_v=-14947 uv1_u=-12760 uv1_v=-15047 uv2_u=-12793 uv2_v=-15042 view_x=-9785 view_y=8500 view_z=-2064 light0_x=17552 light0_y=27551 light0_z=234
--   mirrored: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-2251 p0_y=-12103 p0_z=-4471 p1_x=-2315 p1_y=-12265 p1_z=-4389 p2_x=-2396 p2_y=-12196 p2_z=-4368 uv0_u=-15135 uv0_v=-8131 uv1_u=-7065 uv1_v=-24240 uv2_u=-5879 uv2_v=-14467 view_x=-498 view_y=-7436 view_z=1651 light0_x=-5316 light0_y=3367 light0_z=5947
--   degenerate: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-2251 p0_y=-12103 p0_z=-4471 p1_x=-2315 p1_y=-12265 p1_z=-4389 p2_x=-2396 p2_y=-12196 p2_z=-4368 uv0_u=-15135 uv0_v=-8131 uv1_u=-7065 uv1_v=-24240 uv2_u=-5879 uv2_v=-14467 view_x=-498 view_y=-7436 view_z=1651 light0_x=-5316 light0_y=3367 light0_z=5947
--   zero_uv: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-2251 p0_y=-12103 p0_z=-4471 p1_x=-2315 p1_y=-12265 p1_z=-4389 p2_x=-2396 p2_y=-12196 p2_z=-4368 uv0_u=-15135 uv0_v=-8131 uv1_u=-7065 uv1_v=-24240 uv2_u=-5879 uv2_v=-14467 view_x=-498 view_y=-7436 view_z=1651 light0_x=-5316 light0_y=3367 light0_z=5947
--   zero_area: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-2251 p0_y=-12103 p0_z=-4471 p1_x=-2315 p1_y=-12265 p1_z=-4389 p2_x=-2396 p2_y=-12196 p2_z=-4368 uv0_u=-15135 uv0_v=-8131 uv1_u=-7065 uv1_v=-24240 uv2_u=-5879 uv2_v=-14467 view_x=-498 view_y=-7436 view_z=1651 light0_x=-5316 light0_y=3367 light0_z=5947
-- stated bound on each tangent: 5.74e-5
-- stated bound on each binormal: 1.28e-4
-- stated bound on each normal: 5.74e-5
-- stated bound on each view: 5.78e-4
-- stated bound on each light0: 5.78e-4
-- stated bound on each flags: 0.00e0
--
-- Self-checking testbench of tangent_faceted. It reads tangent_faceted_vectors.txt: per line the words of the
-- inputs, then of the expected outputs, in hexadecimal. First all vectors go straight through,
-- one a cycle; then, after a reset in mid-stream, the first 336 go again with stalls and
-- gaps. Every bit of every output and the latency are compared. The last line says PASS or
-- FAIL, and a failure ends with a status that isn't 0, of which GHDL says a line more. With
-- --vcd=FILE, GHDL writes waves.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity tangent_faceted_tb is
end entity;

architecture test of tangent_faceted_tb is
    constant latency : natural := 21;
    constant shown : natural := 10; -- of the mismatches

    -- Each port has its name after dut_, so that it can't be one that is used here.
    signal clk : std_logic := '0';
    signal rst : std_logic := '1';
    signal ce : std_logic := '1';
    signal valid_in : std_logic := '0';
    signal valid_out : std_logic;
    signal dut_p0_x : signed(15 downto 0) := (others => '0');
    signal dut_p0_y : signed(15 downto 0) := (others => '0');
    signal dut_p0_z : signed(15 downto 0) := (others => '0');
    signal dut_p1_x : signed(15 downto 0) := (others => '0');
    signal dut_p1_y : signed(15 downto 0) := (others => '0');
    signal dut_p1_z : signed(15 downto 0) := (others => '0');
    signal dut_p2_x : signed(15 downto 0) := (others => '0');
    signal dut_p2_y : signed(15 downto 0) := (others => '0');
    signal dut_p2_z : signed(15 downto 0) := (others => '0');
    signal dut_uv0_u : signed(15 downto 0) := (others => '0');
    signal dut_uv0_v : signed(15 downto 0) := (others => '0');
    signal dut_uv1_u : signed(15 downto 0) := (others => '0');
    signal dut_uv1_v : signed(15 downto 0) := (others => '0');
    signal dut_uv2_u : signed(15 downto 0) := (others => '0');
    signal dut_uv2_v : signed(15 downto 0) := (others => '0');
    signal dut_view_x : signed(15 downto 0) := (others => '0');
    signal dut_view_y : signed(15 downto 0) := (others => '0');
    signal dut_view_z : signed(15 downto 0) := (others => '0');
    signal dut_light0_x : signed(15 downto 0) := (others => '0');
    signal dut_light0_y : signed(15 downto 0) := (others => '0');
    signal dut_light0_z : signed(15 downto 0) := (others => '0');
    signal dut_t_x : signed(17 downto 0);
    signal dut_t_y : signed(17 downto 0);
    signal dut_t_z : signed(17 downto 0);
    signal dut_b_x : signed(17 downto 0);
    signal dut_b_y : signed(17 downto 0);
    signal dut_b_z : signed(17 downto 0);
    signal dut_n_x : signed(17 downto 0);
    signal dut_n_y : signed(17 downto 0);
    signal dut_n_z : signed(17 downto 0);
    signal dut_ts_view_x : signed(16 downto 0);
    signal dut_ts_view_y : signed(16 downto 0);
    signal dut_ts_view_z : signed(16 downto 0);
    signal dut_ts_light0_x : signed(16 downto 0);
    signal dut_ts_light0_y : signed(16 downto 0);
    signal dut_ts_light0_z : signed(16 downto 0);
    signal dut_mirrored : unsigned(0 downto 0);
    signal dut_degenerate : unsigned(0 downto 0);
    signal dut_zero_uv : unsigned(0 downto 0);
    signal dut_zero_area : unsigned(0 downto 0);
    signal done : boolean := false;

    function hex(word : std_logic_vector) return string is
        variable digits : string(1 to (word'length + 3) / 4) := to_hstring(word);
    begin
        for i in digits'range loop
            if digits(i) >= 'A' and digits(i) <= 'F' then
                digits(i) := character'val(character'pos(digits(i)) + 32);
            end if;
        end loop;
        return digits;
    end function;
begin
    dut : entity work.tangent_faceted
        port map (
            clk => clk, rst => rst, ce => ce,
            valid_in => valid_in, valid_out => valid_out,
            p0_x => dut_p0_x,
            p0_y => dut_p0_y,
            p0_z => dut_p0_z,
            p1_x => dut_p1_x,
            p1_y => dut_p1_y,
            p1_z => dut_p1_z,
            p2_x => dut_p2_x,
            p2_y => dut_p2_y,
            p2_z => dut_p2_z,
            uv0_u => dut_uv0_u,
            uv0_v => dut_uv0_v,
            uv1_u => dut_uv1_u,
            uv1_v => dut_uv1_v,
            uv2_u => dut_uv2_u,
            uv2_v => dut_uv2_v,
            view_x => dut_view_x,
            view_y => dut_view_y,
            view_z => dut_view_z,
            light0_x => dut_light0_x,
            light0_y => dut_light0_y,
            light0_z => dut_light0_z,
            t_x => dut_t_x,
            t_y => dut_t_y,
            t_z => dut_t_z,
            b_x => dut_b_x,
            b_y => dut_b_y,
            b_z => dut_b_z,
            n_x => dut_n_x,
            n_y => dut_n_y,
            n_z => dut_n_z,
            ts_view_x => dut_ts_view_x,
            ts_view_y => dut_ts_view_y,
            ts_view_z => dut_ts_view_z,
            ts_light0_x => dut_ts_light0_x,
            ts_light0_y => dut_ts_light0_y,
            ts_light0_z => dut_ts_light0_z,
            mirrored => dut_mirrored,
            degenerate => dut_degenerate,
            zero_uv => dut_zero_uv,
            zero_area => dut_zero_area
        );

    clk <= not clk after 5 ns when not done;

    process
        type words_t is array (0 to latency) of std_logic_vector(267 downto 0);
        type numbers_t is array (0 to latency) of natural;

        -- What should come out, moving beside the pipeline; entry 0 belongs to what goes in.
        variable expected : words_t;
        variable valid : std_logic_vector(0 to latency) := (others => '0');
        variable number : numbers_t;

        file vectors : text;
        constant count : natural := 336;
        variable sent, checked, mismatches, passed : natural := 0;
        variable more, stalls, reset_done, started : boolean := false;
        variable lfsr : unsigned(31 downto 0) := 32x"2545f491"; -- decides on stalls and gaps
        variable next_p0_x : std_logic_vector(15 downto 0) := (others => '0');
        variable next_p0_y : std_logic_vector(15 downto 0) := (others => '0');
        variable next_p0_z : std_logic_vector(15 downto 0) := (others => '0');
        variable next_p1_x : std_logic_vector(15 downto 0) := (others => '0');
        variable next_p1_y : std_logic_vector(15 downto 0) := (others => '0');
        variable next_p1_z : std_logic_vector(15 downto 0) := (others => '0');
        variable next_p2_x : std_logic_vector(15 downto 0) := (others => '0');
        variable next_p2_y : std_logic_vector(15 downto 0) := (others => '0');
        variable next_p2_z : std_logic_vector(15 downto 0) := (others => '0');
        variable next_uv0_u : std_logic_vector(15 downto 0) := (others => '0');
        variable next_uv0_v : std_logic_vector(15 downto 0) := (others => '0');
        variable next_uv1_u : std_logic_vector(15 downto 0) := (others => '0');
        variable next_uv1_v : std_logic_vector(15 downto 0) := (others => '0');
        variable next_uv2_u : std_logic_vector(15 downto 0) := (others => '0');
        variable next_uv2_v : std_logic_vector(15 downto 0) := (others => '0');
        variable next_view_x : std_logic_vector(15 downto 0) := (others => '0');
        variable next_view_y : std_logic_vector(15 downto 0) := (others => '0');
        variable next_view_z : std_logic_vector(15 downto 0) := (others => '0');
        variable next_light0_x : std_logic_vector(15 downto 0) := (others => '0');
        variable next_light0_y : std_logic_vector(15 downto 0) := (others => '0');
        variable next_light0_z : std_logic_vector(15 downto 0) := (others => '0');
        variable next_t_x : std_logic_vector(17 downto 0) := (others => '0');
        variable next_t_y : std_logic_vector(17 downto 0) := (others => '0');
        variable next_t_z : std_logic_vector(17 downto 0) := (others => '0');
        variable next_b_x : std_logic_vector(17 downto 0) := (others => '0');
        variable next_b_y : std_logic_vector(17 downto 0) := (others => '0');
        variable next_b_z : std_logic_vector(17 downto 0) := (others => '0');
        variable next_n_x : std_logic_vector(17 downto 0) := (others => '0');
        variable next_n_y : std_logic_vector(17 downto 0) := (others => '0');
        variable next_n_z : std_logic_vector(17 downto 0) := (others => '0');
        variable next_ts_view_x : std_logic_vector(16 downto 0) := (others => '0');
        variable next_ts_view_y : std_logic_vector(16 downto 0) := (others => '0');
        variable next_ts_view_z : std_logic_vector(16 downto 0) := (others => '0');
        variable next_ts_light0_x : std_logic_vector(16 downto 0) := (others => '0');
        variable next_ts_light0_y : std_logic_vector(16 downto 0) := (others => '0');
        variable next_ts_light0_z : std_logic_vector(16 downto 0) := (others => '0');
        variable next_mirrored : std_logic_vector(0 downto 0) := (others => '0');
        variable next_degenerate : std_logic_vector(0 downto 0) := (others => '0');
        variable next_zero_uv : std_logic_vector(0 downto 0) := (others => '0');
        variable next_zero_area : std_logic_vector(0 downto 0) := (others => '0');

        procedure print(message : string) is
        begin
            write(output, message & LF);
        end procedure;

        procedure mismatch(message : string) is
        begin
            mismatches := mismatches + 1;
            if mismatches <= shown then
                print("mismatch: " & message);
            end if;
        end procedure;

        procedure open_vectors is
            variable status : file_open_status;
        begin
            sent := 0;
            checked := 0;
            more := true;
            reset_done := false;
            file_open(status, vectors, "tangent_faceted_vectors.txt", read_mode);
            if status /= open_ok then
                print("FAIL: tangent_faceted_vectors.txt can't be read");
                std.env.finish(1);
            end if;
        end procedure;

        procedure read_vector is
            variable words : line;
            variable good : boolean;
        begin
            more := false;
            while not endfile(vectors) and not more loop
                readline(vectors, words);
                more := words'length > 0;
            end loop;
            if more then
                hread(words, next_p0_x, good);
                more := more and good;
                hread(words, next_p0_y, good);
                more := more and good;
                hread(words, next_p0_z, good);
                more := more and good;
                hread(words, next_p1_x, good);
                more := more and good;
                hread(words, next_p1_y, good);
                more := more and good;
                hread(words, next_p1_z, good);
                more := more and good;
                hread(words, next_p2_x, good);
                more := more and good;
                hread(words, next_p2_y, good);
                more := more and good;
                hread(words, next_p2_z, good);
                more := more and good;
                hread(words, next_uv0_u, good);
                more := more and good;
                hread(words, next_uv0_v, good);
                more := more and good;
                hread(words, next_uv1_u, good);
                more := more and good;
                hread(words, next_uv1_v, good);
                more := more and good;
                hread(words, next_uv2_u, good);
                more := more and good;
                hread(words, next_uv2_v, good);
                more := more and good;
                hread(words, next_view_x, good);
                more := more and good;
                hread(words, next_view_y, good);
                more := more and good;
                hread(words, next_view_z, good);
                more := more and good;
                hread(words, next_light0_x, good);
                more := more and good;
                hread(words, next_light0_y, good);
                more := more and good;
                hread(words, next_light0_z, good);
                more := more and good;
                hread(words, next_t_x, good);
                more := more and good;
                hread(words, next_t_y, good);
                more := more and good;
                hread(words, next_t_z, good);
                more := more and good;
                hread(words, next_b_x, good);
                more := more and good;
                hread(words, next_b_y, good);
                more := more and good;
                hread(words, next_b_z, good);
                more := more and good;
                hread(words, next_n_x, good);
                more := more and good;
                hread(words, next_n_y, good);
                more := more and good;
                hread(words, next_n_z, good);
                more := more and good;
                hread(words, next_ts_view_x, good);
                more := more and good;
                hread(words, next_ts_view_y, good);
                more := more and good;
                hread(words, next_ts_view_z, good);
                more := more and good;
                hread(words, next_ts_light0_x, good);
                more := more and good;
                hread(words, next_ts_light0_y, good);
                more := more and good;
                hread(words, next_ts_light0_z, good);
                more := more and good;
                hread(words, next_mirrored, good);
                more := more and good;
                hread(words, next_degenerate, good);
                more := more and good;
                hread(words, next_zero_uv, good);
                more := more and good;
                hread(words, next_zero_area, good);
                more := more and good;
                if not more then
                    mismatches := mismatches + 1;
                    print("mismatch: tangent_faceted_vectors.txt is cut short after vector " & to_string(sent));
                end if;
            end if;
        end procedure;

        procedure check is
            procedure check_port(port_name : string; want, got : std_logic_vector) is
            begin
                if got /= want then
                    mismatch("vector " & to_string(number(latency)) & " " & port_name
                        & " expected " & hex(want) & " got " & hex(got));
                end if;
            end procedure;
        begin
            -- Nothing is known before the first edge under reset.
            if started and valid_out /= valid(latency) then
                mismatch("vector " & to_string(checked) & " valid_out expected "
                    & to_string(valid(latency)) & " got " & to_string(valid_out));
            end if;
            -- Each word counts once: in the cycle after which the pipeline moves on.
            if ce = '1' and valid(latency) = '1' then
                check_port("t_x", expected(latency)(267 downto 250),
                    std_logic_vector(dut_t_x));
                check_port("t_y", expected(latency)(249 downto 232),
                    std_logic_vector(dut_t_y));
                check_port("t_z", expected(latency)(231 downto 214),
                    std_logic_vector(dut_t_z));
                check_port("b_x", expected(latency)(213 downto 196),
                    std_logic_vector(dut_b_x));
                check_port("b_y", expected(latency)(195 downto 178),
                    std_logic_vector(dut_b_y));
                check_port("b_z", expected(latency)(177 downto 160),
                    std_logic_vector(dut_b_z));
                check_port("n_x", expected(latency)(159 downto 142),
                    std_logic_vector(dut_n_x));
                check_port("n_y", expected(latency)(141 downto 124),
                    std_logic_vector(dut_n_y));
                check_port("n_z", expected(latency)(123 downto 106),
                    std_logic_vector(dut_n_z));
                check_port("ts_view_x", expected(latency)(105 downto 89),
                    std_logic_vector(dut_ts_view_x));
                check_port("ts_view_y", expected(latency)(88 downto 72),
                    std_logic_vector(dut_ts_view_y));
                check_port("ts_view_z", expected(latency)(71 downto 55),
                    std_logic_vector(dut_ts_view_z));
                check_port("ts_light0_x", expected(latency)(54 downto 38),
                    std_logic_vector(dut_ts_light0_x));
                check_port("ts_light0_y", expected(latency)(37 downto 21),
                    std_logic_vector(dut_ts_light0_y));
                check_port("ts_light0_z", expected(latency)(20 downto 4),
                    std_logic_vector(dut_ts_light0_z));
                check_port("mirrored", expected(latency)(3 downto 3),
                    std_logic_vector(dut_mirrored));
                check_port("degenerate", expected(latency)(2 downto 2),
                    std_logic_vector(dut_degenerate));
                check_port("zero_uv", expected(latency)(1 downto 1),
                    std_logic_vector(dut_zero_uv));
                check_port("zero_area", expected(latency)(0 downto 0),
                    std_logic_vector(dut_zero_area));
                checked := checked + 1;
            end if;
        end procedure;

        procedure move_on is
        begin
            for i in latency downto 1 loop
                if rst = '1' then
                    valid(i) := '0';
                elsif ce = '1' then
                    valid(i) := valid(i - 1);
                end if;
                if ce = '1' then
                    expected(i) := expected(i - 1);
                    number(i) := number(i - 1);
                end if;
            end loop;
        end procedure;

        -- What goes in after this edge: words stay where the pipeline stood still.
        procedure drive is
        begin
            lfsr := lfsr(30 downto 0) & (lfsr(31) xor lfsr(21) xor lfsr(1) xor lfsr(0));
            rst <= '0';
            ce <= '1';
            if stalls and lfsr(2 downto 0) = 0 then
                ce <= '0';
            end if;
            if ce = '1' then
                valid(0) := '0';
                if more and not (stalls and lfsr(5 downto 3) = 0) then
                    read_vector;
                    if more then
                        valid(0) := '1';
                        expected(0)(267 downto 250) := next_t_x;
                        expected(0)(249 downto 232) := next_t_y;
                        expected(0)(231 downto 214) := next_t_z;
                        expected(0)(213 downto 196) := next_b_x;
                        expected(0)(195 downto 178) := next_b_y;
                        expected(0)(177 downto 160) := next_b_z;
                        expected(0)(159 downto 142) := next_n_x;
                        expected(0)(141 downto 124) := next_n_y;
                        expected(0)(123 downto 106) := next_n_z;
                        expected(0)(105 downto 89) := next_ts_view_x;
                        expected(0)(88 downto 72) := next_ts_view_y;
                        expected(0)(71 downto 55) := next_ts_view_z;
                        expected(0)(54 downto 38) := next_ts_light0_x;
                        expected(0)(37 downto 21) := next_ts_light0_y;
                        expected(0)(20 downto 4) := next_ts_light0_z;
                        expected(0)(3 downto 3) := next_mirrored;
                        expected(0)(2 downto 2) := next_degenerate;
                        expected(0)(1 downto 1) := next_zero_uv;
                        expected(0)(0 downto 0) := next_zero_area;
                        number(0) := sent;
                        sent := sent + 1;
                        if stalls and sent = 336 then
                            more := false;
                        end if;
                    end if;
                end if;
                valid_in <= valid(0);
                -- A gap carries the opposite of the latest word.
                if valid(0) = '1' then
                    dut_p0_x <= signed(next_p0_x);
                    dut_p0_y <= signed(next_p0_y);
                    dut_p0_z <= signed(next_p0_z);
                    dut_p1_x <= signed(next_p1_x);
                    dut_p1_y <= signed(next_p1_y);
                    dut_p1_z <= signed(next_p1_z);
                    dut_p2_x <= signed(next_p2_x);
                    dut_p2_y <= signed(next_p2_y);
                    dut_p2_z <= signed(next_p2_z);
                    dut_uv0_u <= signed(next_uv0_u);
                    dut_uv0_v <= signed(next_uv0_v);
                    dut_uv1_u <= signed(next_uv1_u);
                    dut_uv1_v <= signed(next_uv1_v);
                    dut_uv2_u <= signed(next_uv2_u);
                    dut_uv2_v <= signed(next_uv2_v);
                    dut_view_x <= signed(next_view_x);
                    dut_view_y <= signed(next_view_y);
                    dut_view_z <= signed(next_view_z);
                    dut_light0_x <= signed(next_light0_x);
                    dut_light0_y <= signed(next_light0_y);
                    dut_light0_z <= signed(next_light0_z);
                else
                    dut_p0_x <= signed(not next_p0_x);
                    dut_p0_y <= signed(not next_p0_y);
                    dut_p0_z <= signed(not next_p0_z);
                    dut_p1_x <= signed(not next_p1_x);
                    dut_p1_y <= signed(not next_p1_y);
                    dut_p1_z <= signed(not next_p1_z);
                    dut_p2_x <= signed(not next_p2_x);
                    dut_p2_y <= signed(not next_p2_y);
                    dut_p2_z <= signed(not next_p2_z);
                    dut_uv0_u <= signed(not next_uv0_u);
                    dut_uv0_v <= signed(not next_uv0_v);
                    dut_uv1_u <= signed(not next_uv1_u);
                    dut_uv1_v <= signed(not next_uv1_v);
                    dut_uv2_u <= signed(not next_uv2_u);
                    dut_uv2_v <= signed(not next_uv2_v);
                    dut_view_x <= signed(not next_view_x);
                    dut_view_y <= signed(not next_view_y);
                    dut_view_z <= signed(not next_view_z);
                    dut_light0_x <= signed(not next_light0_x);
                    dut_light0_y <= signed(not next_light0_y);
                    dut_light0_z <= signed(not next_light0_z);
                end if;
            end if;
            -- A reset in mid-stream, which a stall doesn't hold up: what is on its way is forgotten.
            if stalls and not reset_done and sent = 336 / 2 then
                rst <= '1';
                ce <= '0';
                reset_done := true;
            end if;
        end procedure;

        procedure finish is
        begin
            if passed /= count then
                print("mismatch: tangent_faceted_vectors.txt holds " & to_string(passed)
                    & " vectors and should hold " & to_string(count));
            end if;
            if mismatches = 0 and passed = count then
                print("PASS " & to_string(passed) & " vectors");
                done <= true;
            else
                print("FAIL " & to_string(mismatches) & " mismatches in " & to_string(passed)
                    & " vectors");
                std.env.finish(1);
            end if;
        end procedure;
    begin
        open_vectors;
        while not done loop
            wait until rising_edge(clk);
            check;
            if rst = '1' and stalls then
                -- Forgotten, but for what hasn't gone in yet.
                for i in 1 to latency loop
                    if valid(i) = '1' then
                        checked := checked + 1;
                    end if;
                end loop;
            end if;
            move_on;
            drive;
            started := true;
            if not more and checked = sent then
                file_close(vectors);
                if not stalls then
                    passed := checked;
                    stalls := true;
                    open_vectors;
                else
                    finish;
                    wait;
                end if;
            end if;
        end loop;
    end process;
end architecture;
