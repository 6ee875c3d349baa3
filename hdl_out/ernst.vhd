-- ernst: light of a bump-mapped pixel by matrix, normalisation and Cartesian dot products
-- made by fixpath 0.1.0; Ernst et al. 1998, as seed 001 (Lee et al.) counts it in Table 1 and section 4.3
--   normalise=divide divider=non-restoring root=digits frac_bits=16 guard_bits=2 rounding=half-up
--   table_addr_bits=10 scheme=direct recip_addr_bits=auto root_addr_bits=auto highlight=on
--   specular_addr_bits=10 light_scheme=direct light_bits=16 ambient=0.1 diffuse=0.6 specular=0.3
--   exponent=32 period_ps=5000 stages=auto rom=block
-- latency 33 cycles, interval 1 cycle; tables read on the clock
-- absolute errors against the golden of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst:
--   intensity: mean 7.10e-5, largest seen 4.39e-3 (287.8 ulp) at l_x=-17621 l_y=-12812 l_z=61809 h_x=-42849 h_y=10989 h_z=48354 n_x=-27841 n_y=44144 n_z=39637 t_x=42357 t_y=-15868 t_z=47424 b_x=41542 b_y=45765 b_z=-21790 p_x=6319 p_y=-31430 p_z=57160
--   diffuse: mean 7.90e-6, largest seen 3.38e-5 (2.2 ulp) at l_x=8189 l_y=37211 l_z=53322 h_x=11330 h_y=-3065 h_z=64476 n_x=11403 n_y=-35489 n_z=53903 t_x=59242 t_y=-15956 t_z=-23038 b_x=25599 b_y=52734 b_z=29304 p_x=3824 p_y=43866 p_z=48539
--   specular: mean 6.51e-5, largest seen 4.37e-3 (286.6 ulp) at l_x=-17621 l_y=-12812 l_z=61809 h_x=-42849 h_y=10989 h_z=48354 n_x=-27841 n_y=44144 n_z=39637 t_x=42357 t_y=-15868 t_z=47424 b_x=41542 b_y=45765 b_z=-21790 p_x=6319 p_y=-31430 p_z=57160
--   dot_l: mean 5.51e-6, largest seen 2.58e-5 (1.7 ulp) at l_x=8189 l_y=37211 l_z=53322 h_x=11330 h_y=-3065 h_z=64476 n_x=11403 n_y=-35489 n_z=53903 t_x=59242 t_y=-15956 t_z=-23038 b_x=25599 b_y=52734 b_z=29304 p_x=3824 p_y=43866 p_z=48539
--   dot_h: mean 5.55e-6, largest seen 2.64e-5 (1.7 ulp) at l_x=28436 l_y=58436 l_z=-8465 h_x=56347 h_y=29067 h_z=-16587 n_x=7268 n_y=55465 n_z=-34143 t_x=-16808 t_y=-31594 t_z=-54902 b_x=-62926 b_y=14846 b_z=10722 p_x=17769 p_y=-44293 p_z=44914
--   lt_angle: mean 5.96e-6 rad, largest seen 1.52e-5 rad at l_x=-46104 l_y=2218 l_z=46524 h_x=-34894 h_y=-9840 h_z=54594 n_x=-8835 n_y=57118 n_z=30893 t_x=27988 t_y=31483 t_z=-50204 b_x=-58597 b_y=6425 b_z=-28637 p_x=-41292 p_y=29455 p_z=41501
--   lt_dot: mean 7.58e-6, largest seen 1.60e-5 at l_x=-51507 l_y=24581 l_z=-32215 h_x=-48499 h_y=-39070 h_z=-20406 n_x=-49786 n_y=-42007 n_z=7192 t_x=-40759 t_y=43701 t_z=-26905 b_x=12449 b_y=-24912 b_z=-59324 p_x=18646 p_y=26903 p_z=56776
--   lt_x: mean 3.93e-6, largest seen 1.06e-5 (0.7 ulp) at l_x=-15279 l_y=5067 l_z=63528 h_x=29170 h_y=-18014 h_z=55853 n_x=53184 n_y=30871 n_z=22658 t_x=9050 t_y=-47812 t_z=43899 b_x=37209 b_y=-32496 b_z=-43064 p_x=30395 p_y=-14945 p_z=56105
--   lt_y: mean 3.92e-6, largest seen 1.06e-5 (0.7 ulp) at l_x=-33544 l_y=8570 l_z=55645 h_x=3237 h_y=45027 h_z=47509 n_x=51579 n_y=35193 n_z=-19899 t_x=-23525 t_y=-107 t_z=-61168 b_x=-32880 b_y=55285 b_z=12549 p_x=35175 p_y=37290 p_z=40831
--   lt_z: mean 3.90e-6, largest seen 1.06e-5 (0.7 ulp) at l_x=60216 l_y=-731 l_z=25854 h_x=28155 h_y=-38009 h_z=45360 n_x=49800 n_y=-42419 n_z=3954 t_x=-7689 t_y=-2967 t_z=65016 b_x=-41903 b_y=-49868 b_z=-7231 p_x=38689 p_y=13334 p_z=51189
--   ht_angle: mean 5.97e-6 rad, largest seen 1.55e-5 rad at l_x=-42413 l_y=5315 l_z=-49678 h_x=-49190 h_y=10077 h_z=-42117 n_x=31825 n_y=43565 n_z=-37205 t_x=52333 t_y=-39424 t_z=-1398 b_x=-23310 b_y=-29031 b_z=-53933 p_x=41501 p_y=24164 p_z=44595
--   ht_dot: mean 7.59e-6, largest seen 1.61e-5 at l_x=39313 l_y=33020 l_z=40732 h_x=45349 h_y=44689 h_z=15535 n_x=-37342 n_y=44334 n_z=30579 t_x=53162 t_y=24386 t_z=29565 b_x=8622 b_y=41651 b_z=-49858 p_x=-25251 p_y=-37777 p_z=47226
--   ht_x: mean 3.92e-6, largest seen 1.07e-5 (0.7 ulp) at l_x=39149 l_y=-824 l_z=-52551 h_x=24132 h_y=-60683 h_z=-5494 n_x=-27035 n_y=-45260 n_z=-38931 t_x=-59525 t_y=17166 t_z=21378 b_x=-4566 b_y=44180 b_z=-48190 p_x=-12132 p_y=43147 p_z=47813
--   ht_y: mean 3.92e-6, largest seen 1.08e-5 (0.7 ulp) at l_x=32246 l_y=-33688 l_z=-46046 h_x=26934 h_y=-37639 h_z=-46399 n_x=15761 n_y=17121 n_z=-61265 t_x=59086 t_y=-27325 t_z=7564 b_x=-23568 b_y=-57054 b_z=-22007 p_x=-27119 p_y=36491 p_z=47201
--   ht_z: mean 3.92e-6, largest seen 1.08e-5 (0.7 ulp) at l_x=-37898 l_y=-11533 l_z=52209 h_x=-54011 h_y=-33479 h_z=-16030 n_x=-19265 n_y=-61659 n_z=-11046 t_x=-4008 t_y=12746 t_z=-64159 b_x=62512 b_y=-18185 b_z=-7518 p_x=10839 p_y=-28061 p_z=58224
-- stated bound on each dot: 7.02e-5
-- stated bound on each diffuse: 8.02e-5
-- stated bound on each specular: 5.24e-3
-- stated bound on each intensity: 5.33e-3
-- stated bound on each component: 1.81e-5
-- bounds hold for L and H in the texture frame, and N', from 1/2 to 2 long
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ernst is
    port (
        clk : in std_logic;
        rst : in std_logic; -- clears the valid bits
        ce : in std_logic; -- the pipeline stands still without
        valid_in : in std_logic;
        l_x : in signed(17 downto 0); -- s18f16
        l_y : in signed(17 downto 0); -- s18f16
        l_z : in signed(17 downto 0); -- s18f16
        h_x : in signed(17 downto 0); -- s18f16
        h_y : in signed(17 downto 0); -- s18f16
        h_z : in signed(17 downto 0); -- s18f16
        n_x : in signed(17 downto 0); -- s18f16
        n_y : in signed(17 downto 0); -- s18f16
        n_z : in signed(17 downto 0); -- s18f16
        t_x : in signed(17 downto 0); -- s18f16
        t_y : in signed(17 downto 0); -- s18f16
        t_z : in signed(17 downto 0); -- s18f16
        b_x : in signed(17 downto 0); -- s18f16
        b_y : in signed(17 downto 0); -- s18f16
        b_z : in signed(17 downto 0); -- s18f16
        p_x : in signed(17 downto 0); -- s18f16
        p_y : in signed(17 downto 0); -- s18f16
        p_z : in signed(17 downto 0); -- s18f16
        valid_out : out std_logic;
        intensity : out unsigned(15 downto 0) := (others => '0'); -- u16f16
        diffuse : out unsigned(15 downto 0) := (others => '0'); -- u16f16
        specular : out unsigned(15 downto 0) := (others => '0') -- u16f16
    );
end entity;

architecture rtl of ernst is
    attribute rom_style : string;

    -- table specular: light u16f16
    type specular_rom_rows is array (0 to 1023) of unsigned(15 downto 0);
    constant specular_rom : specular_rom_rows := (
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0000", 16x"0000", 16x"0000", 16x"0000",
        16x"0001", 16x"0001", 16x"0001", 16x"0001",
        16x"0001", 16x"0001", 16x"0001", 16x"0001",
        16x"0001", 16x"0001", 16x"0001", 16x"0001",
        16x"0001", 16x"0001", 16x"0001", 16x"0001",
        16x"0001", 16x"0001", 16x"0001", 16x"0001",
        16x"0001", 16x"0001", 16x"0001", 16x"0001",
        16x"0001", 16x"0002", 16x"0002", 16x"0002",
        16x"0002", 16x"0002", 16x"0002", 16x"0002",
        16x"0002", 16x"0002", 16x"0002", 16x"0002",
        16x"0002", 16x"0002", 16x"0003", 16x"0003",
        16x"0003", 16x"0003", 16x"0003", 16x"0003",
        16x"0003", 16x"0003", 16x"0004", 16x"0004",
        16x"0004", 16x"0004", 16x"0004", 16x"0004",
        16x"0005", 16x"0005", 16x"0005", 16x"0005",
        16x"0005", 16x"0006", 16x"0006", 16x"0006",
        16x"0006", 16x"0007", 16x"0007", 16x"0007",
        16x"0007", 16x"0008", 16x"0008", 16x"0008",
        16x"0009", 16x"0009", 16x"0009", 16x"000a",
        16x"000a", 16x"000b", 16x"000b", 16x"000c",
        16x"000c", 16x"000c", 16x"000d", 16x"000d",
        16x"000e", 16x"000f", 16x"000f", 16x"0010",
        16x"0010", 16x"0011", 16x"0012", 16x"0012",
        16x"0013", 16x"0014", 16x"0015", 16x"0016",
        16x"0016", 16x"0017", 16x"0018", 16x"0019",
        16x"001a", 16x"001b", 16x"001c", 16x"001d",
        16x"001e", 16x"0020", 16x"0021", 16x"0022",
        16x"0023", 16x"0025", 16x"0026", 16x"0028",
        16x"0029", 16x"002b", 16x"002c", 16x"002e",
        16x"0030", 16x"0032", 16x"0034", 16x"0036",
        16x"0038", 16x"003a", 16x"003c", 16x"003e",
        16x"0041", 16x"0043", 16x"0046", 16x"0048",
        16x"004b", 16x"004e", 16x"0051", 16x"0054",
        16x"0057", 16x"005a", 16x"005e", 16x"0061",
        16x"0065", 16x"0069", 16x"006d", 16x"0071",
        16x"0075", 16x"0079", 16x"007e", 16x"0083",
        16x"0088", 16x"008d", 16x"0092", 16x"0097",
        16x"009d", 16x"00a3", 16x"00a9", 16x"00af",
        16x"00b5", 16x"00bc", 16x"00c3", 16x"00ca",
        16x"00d1", 16x"00d9", 16x"00e1", 16x"00e9",
        16x"00f2", 16x"00fb", 16x"0104", 16x"010d",
        16x"0117", 16x"0121", 16x"012c", 16x"0136",
        16x"0142", 16x"014d", 16x"0159", 16x"0166",
        16x"0173", 16x"0180", 16x"018e", 16x"019c",
        16x"01ab", 16x"01ba", 16x"01ca", 16x"01da",
        16x"01eb", 16x"01fd", 16x"020f", 16x"0222",
        16x"0235", 16x"0249", 16x"025e", 16x"0273",
        16x"028a", 16x"02a1", 16x"02b8", 16x"02d1",
        16x"02ea", 16x"0305", 16x"0320", 16x"033c",
        16x"0359", 16x"0377", 16x"0396", 16x"03b6",
        16x"03d7", 16x"03fa", 16x"041d", 16x"0442",
        16x"0468", 16x"048f", 16x"04b7", 16x"04e1",
        16x"050c", 16x"0539", 16x"0567", 16x"0597",
        16x"05c9", 16x"05fb", 16x"0630", 16x"0667",
        16x"069f", 16x"06d9", 16x"0715", 16x"0753",
        16x"0793", 16x"07d5", 16x"081a", 16x"0861",
        16x"08aa", 16x"08f5", 16x"0943", 16x"0993",
        16x"09e6", 16x"0a3c", 16x"0a95", 16x"0af0",
        16x"0b4f", 16x"0bb0", 16x"0c15", 16x"0c7d",
        16x"0ce9", 16x"0d58", 16x"0dca", 16x"0e41",
        16x"0ebb", 16x"0f39", 16x"0fbb", 16x"1041",
        16x"10cc", 16x"115b", 16x"11ef", 16x"1287",
        16x"1325", 16x"13c7", 16x"146f", 16x"151c",
        16x"15cf", 16x"1687", 16x"1745", 16x"180a",
        16x"18d4", 16x"19a5", 16x"1a7d", 16x"1b5b",
        16x"1c41", 16x"1d2e", 16x"1e22", 16x"1f1e",
        16x"2023", 16x"212f", 16x"2244", 16x"2361",
        16x"2488", 16x"25b8", 16x"26f1", 16x"2834",
        16x"2981", 16x"2ad9", 16x"2c3c", 16x"2da9",
        16x"2f22", 16x"30a7", 16x"3238", 16x"33d6",
        16x"3580", 16x"3737", 16x"38fd", 16x"3ad0",
        16x"3cb2", 16x"3ea2", 16x"40a2", 16x"42b2",
        16x"44d2", 16x"4703", 16x"4945", 16x"4b99"
    );
    attribute rom_style of specular_rom : constant is "block";

    -- Words start at zero: numeric_std would warn of what it compares or looks up before.
    -- Valid bits don't, so that one that a reset misses shows as unknown.
    -- stage 0
    signal setup_light_n18 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_light_n19 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_light_n20 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_light_n24 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_light_n25 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_light_n26 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_light_n30 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_light_n31 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_light_n32 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_light_length_n42 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n43 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n327 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_unit_x_n343 : unsigned(0 downto 0) := (others => '0'); -- u1e1
    signal setup_light_unit_x_n388 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_light_unit_x_n396 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_n989 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_half_n990 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_half_n991 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_half_n995 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_half_n996 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_half_n997 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_half_n1001 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_half_n1002 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_half_n1003 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_bump_n1954 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_bump_n1955 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_bump_n1956 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_bump_unit_x_n2215_neg : unsigned(17 downto 0) := (others => '0');
    signal setup_bump_unit_x_n2215 : unsigned(17 downto 0) := (others => '0'); -- u18f16
    signal setup_bump_unit_x_n2217 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2218 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2219 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2220 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2221 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2222 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2223 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2224 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2225 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2226 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2227 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2228 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2229 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2230 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2231 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2232 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2233 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2234 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2235 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_unit_x_n2236 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_bump_unit_x_n2237 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_bump_unit_x_n2238 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_bump_unit_x_n2239 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_bump_unit_x_n2240 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_bump_unit_x_n2241 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal setup_bump_unit_x_n2242 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_bump_unit_x_n2243 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_bump_unit_x_n2244 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_bump_unit_x_n2245 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_bump_unit_x_n2246 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_bump_unit_x_n2247 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal setup_bump_unit_x_n2248 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_bump_unit_x_n2249 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_bump_unit_x_n2250 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_bump_unit_x_n2251 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_x_n2254 : unsigned(40 downto 0) := (others => '0'); -- u41f0
    signal setup_bump_unit_x_n2255 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_bump_unit_x_n2256 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_x_n2257 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_x_n2258 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_x_n2259 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2417 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2419 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2423_neg : unsigned(17 downto 0) := (others => '0');
    signal setup_bump_unit_y_n2423 : unsigned(17 downto 0) := (others => '0'); -- u18f16
    signal setup_bump_unit_y_n2424 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2425 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2426 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2427 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2428 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2429 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2430 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2431 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2432 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2433 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2434 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2435 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2436 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2437 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2438 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2439 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2440 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2441 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2442 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_unit_y_n2443 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_bump_unit_y_n2444 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_bump_unit_y_n2445 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_bump_unit_y_n2446 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_bump_unit_y_n2447 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_bump_unit_y_n2448 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal setup_bump_unit_y_n2449 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_bump_unit_y_n2450 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_bump_unit_y_n2451 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_bump_unit_y_n2452 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_bump_unit_y_n2453 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_bump_unit_y_n2454 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal setup_bump_unit_y_n2455 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_bump_unit_y_n2456 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_bump_unit_y_n2457 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_bump_unit_y_n2458 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_y_n2461 : unsigned(40 downto 0) := (others => '0'); -- u41f0
    signal setup_bump_unit_y_n2462 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_bump_unit_y_n2463 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_y_n2464 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_y_n2465 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_y_n2466 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2623 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2625 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2629_neg : unsigned(17 downto 0) := (others => '0');
    signal setup_bump_unit_z_n2629 : unsigned(17 downto 0) := (others => '0'); -- u18f16
    signal setup_bump_unit_z_n2630 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2631 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2632 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2633 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2634 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2635 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2636 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2637 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2638 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2639 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2640 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2641 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2642 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2643 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2644 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2645 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2646 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2647 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2648 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_unit_z_n2649 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_bump_unit_z_n2650 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_bump_unit_z_n2651 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_bump_unit_z_n2652 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_bump_unit_z_n2653 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_bump_unit_z_n2654 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal setup_bump_unit_z_n2655 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_bump_unit_z_n2656 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_bump_unit_z_n2657 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_bump_unit_z_n2658 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_bump_unit_z_n2659 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_bump_unit_z_n2660 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal setup_bump_unit_z_n2661 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_bump_unit_z_n2662 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_bump_unit_z_n2663 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_bump_unit_z_n2664 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_z_n2667 : unsigned(40 downto 0) := (others => '0'); -- u41f0
    signal setup_bump_unit_z_n2668 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_bump_unit_z_n2669 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_z_n2670 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_z_n2671 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_z_n2672 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2829 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2831 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal diffuse_n2850 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal diffuse_n2853 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal diffuse_n2854 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal n2866 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal n2867 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal setup_light_n18_s1 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_light_n19_s1 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_light_n20_s1 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_light_n24_s1 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_light_n25_s1 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_light_n26_s1 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_light_n30_s1 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_light_n31_s1 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_light_n32_s1 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_light_length_n327_s1 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_unit_x_n396_s1 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_n989_s1 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_half_n990_s1 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_half_n991_s1 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_half_n995_s1 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_half_n996_s1 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_half_n997_s1 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_half_n1001_s1 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_half_n1002_s1 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_half_n1003_s1 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_bump_n1954_s1 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_bump_n1955_s1 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_bump_n1956_s1 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal setup_bump_unit_x_n2251_s1 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_x_n2259_s1 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2417_s1 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2419_s1 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2458_s1 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_y_n2466_s1 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2623_s1 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2625_s1 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2664_s1 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_z_n2672_s1 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2829_s1 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2831_s1 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s1 : std_logic;
    -- stage 1
    signal setup_light_n21 : signed(36 downto 0) := (others => '0'); -- s37f32
    signal setup_light_n22 : signed(37 downto 0) := (others => '0'); -- s38f32
    signal setup_light_n27 : signed(36 downto 0) := (others => '0'); -- s37f32
    signal setup_light_n28 : signed(37 downto 0) := (others => '0'); -- s38f32
    signal setup_light_n33 : signed(36 downto 0) := (others => '0'); -- s37f32
    signal setup_light_n34 : signed(37 downto 0) := (others => '0'); -- s38f32
    signal setup_half_n992 : signed(36 downto 0) := (others => '0'); -- s37f32
    signal setup_half_n993 : signed(37 downto 0) := (others => '0'); -- s38f32
    signal setup_half_n998 : signed(36 downto 0) := (others => '0'); -- s37f32
    signal setup_half_n999 : signed(37 downto 0) := (others => '0'); -- s38f32
    signal setup_half_n1004 : signed(36 downto 0) := (others => '0'); -- s37f32
    signal setup_half_n1005 : signed(37 downto 0) := (others => '0'); -- s38f32
    signal setup_bump_n1957 : signed(36 downto 0) := (others => '0'); -- s37f32
    signal setup_bump_n1958 : signed(37 downto 0) := (others => '0'); -- s38f32
    signal setup_bump_square_under : unsigned(0 downto 0) := (others => '0');
    signal setup_bump_square : unsigned(36 downto 0) := (others => '0'); -- u37f32
    signal setup_bump_length_n1960 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n1961 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n1962 : signed(2 downto 0) := (others => '0'); -- s3f0
    signal setup_bump_length_n1963 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n1967 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n1968 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n1969 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n1979 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n1980 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n1981 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n1991 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n1992 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n1993 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2003 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2004 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2005 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2015 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2016 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2017 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2027 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2028 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2029 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2039 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2040 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2041 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2051 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2052 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2053 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2063 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2064 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2065 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2075 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2076 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2077 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2087 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2088 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2089 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2099 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2100 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2101 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2111 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2112 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2113 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2123 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2124 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2125 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2135 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2136 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2137 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2147 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2148 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2149 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2159 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2160 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2161 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2171 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2172 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2173 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_n22_s2 : signed(37 downto 0) := (others => '0'); -- s38f32
    signal setup_light_n28_s2 : signed(37 downto 0) := (others => '0'); -- s38f32
    signal setup_light_n34_s2 : signed(37 downto 0) := (others => '0'); -- s38f32
    signal setup_light_length_n327_s2 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_unit_x_n396_s2 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_n993_s2 : signed(37 downto 0) := (others => '0'); -- s38f32
    signal setup_half_n999_s2 : signed(37 downto 0) := (others => '0'); -- s38f32
    signal setup_half_n1005_s2 : signed(37 downto 0) := (others => '0'); -- s38f32
    signal setup_bump_length_n1961_s2 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n1962_s2 : signed(2 downto 0) := (others => '0'); -- s3f0
    signal setup_bump_length_n1963_s2 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n1969_s2 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n1981_s2 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n1993_s2 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2005_s2 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2017_s2 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2029_s2 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2041_s2 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2053_s2 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2065_s2 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2077_s2 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2089_s2 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2101_s2 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2113_s2 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2125_s2 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2137_s2 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2149_s2 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2161_s2 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2173_s2 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_unit_x_n2251_s2 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_x_n2259_s2 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2417_s2 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2419_s2 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2458_s2 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_y_n2466_s2 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2623_s2 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2625_s2 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2664_s2 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_z_n2672_s2 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2829_s2 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2831_s2 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s2 : std_logic;
    -- stage 2
    signal setup_light_frame_x_sum : signed(38 downto 0) := (others => '0');
    signal setup_light_frame_x_cut : signed(24 downto 0) := (others => '0');
    signal setup_light_frame_x_over : unsigned(0 downto 0) := (others => '0');
    signal setup_light_frame_x_under : unsigned(0 downto 0) := (others => '0');
    signal setup_light_frame_x : signed(22 downto 0) := (others => '0'); -- s23f18
    signal setup_light_frame_y_sum : signed(38 downto 0) := (others => '0');
    signal setup_light_frame_y_cut : signed(24 downto 0) := (others => '0');
    signal setup_light_frame_y_over : unsigned(0 downto 0) := (others => '0');
    signal setup_light_frame_y_under : unsigned(0 downto 0) := (others => '0');
    signal setup_light_frame_y : signed(22 downto 0) := (others => '0'); -- s23f18
    signal setup_light_frame_z_sum : signed(38 downto 0) := (others => '0');
    signal setup_light_frame_z_cut : signed(24 downto 0) := (others => '0');
    signal setup_light_frame_z_over : unsigned(0 downto 0) := (others => '0');
    signal setup_light_frame_z_under : unsigned(0 downto 0) := (others => '0');
    signal setup_light_frame_z : signed(22 downto 0) := (others => '0'); -- s23f18
    signal setup_light_unit_x_n342_neg : unsigned(22 downto 0) := (others => '0');
    signal setup_light_unit_x_n342 : unsigned(22 downto 0) := (others => '0'); -- u23f18
    signal setup_light_unit_x_n345 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n346 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n347 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n348 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n349 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n350 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n351 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n352 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n353 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n354 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n355 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n356 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n357 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n358 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n359 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n360 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n361 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n362 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n363 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n364 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n365 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n366 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_unit_x_n367 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_light_unit_x_n368 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_light_unit_x_n369 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_light_unit_x_n370 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_light_unit_x_n371 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_light_unit_x_n372 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal setup_light_unit_x_n373 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_light_unit_x_n374 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_light_unit_x_n375 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_light_unit_x_n376 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_light_unit_x_n377 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_light_unit_x_n378 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal setup_light_unit_x_n379 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_light_unit_x_n380 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_light_unit_x_n381 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_light_unit_x_n382 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_light_unit_x_n383 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_light_unit_x_n384 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_light_unit_x_n385 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_x_n389 : unsigned(43 downto 0) := (others => '0'); -- u44f0
    signal setup_light_unit_x_n390 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_light_unit_x_n391 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_x_n392 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_x_n393 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n394 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_x_n395 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n402 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n555 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n557 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n561_neg : unsigned(22 downto 0) := (others => '0');
    signal setup_light_unit_y_n561 : unsigned(22 downto 0) := (others => '0'); -- u23f18
    signal setup_light_unit_y_n562 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n563 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n564 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n565 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n566 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n567 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n568 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n569 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n570 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n571 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n572 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n573 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n574 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n575 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n576 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n577 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n578 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n579 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n580 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n581 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n582 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n583 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_unit_y_n584 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_light_unit_y_n585 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_light_unit_y_n586 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_light_unit_y_n587 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_light_unit_y_n588 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_light_unit_y_n589 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal setup_light_unit_y_n590 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_light_unit_y_n591 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_light_unit_y_n592 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_light_unit_y_n593 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_light_unit_y_n594 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_light_unit_y_n595 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal setup_light_unit_y_n596 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_light_unit_y_n597 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_light_unit_y_n598 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_light_unit_y_n599 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_light_unit_y_n600 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_light_unit_y_n601 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_light_unit_y_n602 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_y_n605 : unsigned(43 downto 0) := (others => '0'); -- u44f0
    signal setup_light_unit_y_n606 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_light_unit_y_n607 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_y_n608 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_y_n609 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n610 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_y_n611 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n617 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n769 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n771 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n775_neg : unsigned(22 downto 0) := (others => '0');
    signal setup_light_unit_z_n775 : unsigned(22 downto 0) := (others => '0'); -- u23f18
    signal setup_light_unit_z_n776 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n777 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n778 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n779 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n780 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n781 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n782 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n783 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n784 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n785 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n786 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n787 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n788 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n789 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n790 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n791 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n792 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n793 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n794 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n795 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n796 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n797 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_unit_z_n798 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_light_unit_z_n799 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_light_unit_z_n800 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_light_unit_z_n801 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_light_unit_z_n802 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_light_unit_z_n803 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal setup_light_unit_z_n804 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_light_unit_z_n805 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_light_unit_z_n806 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_light_unit_z_n807 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_light_unit_z_n808 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_light_unit_z_n809 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal setup_light_unit_z_n810 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_light_unit_z_n811 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_light_unit_z_n812 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_light_unit_z_n813 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_light_unit_z_n814 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_light_unit_z_n815 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_light_unit_z_n816 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_z_n819 : unsigned(43 downto 0) := (others => '0'); -- u44f0
    signal setup_light_unit_z_n820 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_light_unit_z_n821 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_z_n822 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_z_n823 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n824 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_z_n825 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n831 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n983 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n985 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_frame_x_sum : signed(38 downto 0) := (others => '0');
    signal setup_half_frame_x_cut : signed(24 downto 0) := (others => '0');
    signal setup_half_frame_x_over : unsigned(0 downto 0) := (others => '0');
    signal setup_half_frame_x_under : unsigned(0 downto 0) := (others => '0');
    signal setup_half_frame_x : signed(22 downto 0) := (others => '0'); -- s23f18
    signal setup_half_frame_y_sum : signed(38 downto 0) := (others => '0');
    signal setup_half_frame_y_cut : signed(24 downto 0) := (others => '0');
    signal setup_half_frame_y_over : unsigned(0 downto 0) := (others => '0');
    signal setup_half_frame_y_under : unsigned(0 downto 0) := (others => '0');
    signal setup_half_frame_y : signed(22 downto 0) := (others => '0'); -- s23f18
    signal setup_half_frame_z_sum : signed(38 downto 0) := (others => '0');
    signal setup_half_frame_z_cut : signed(24 downto 0) := (others => '0');
    signal setup_half_frame_z_over : unsigned(0 downto 0) := (others => '0');
    signal setup_half_frame_z_under : unsigned(0 downto 0) := (others => '0');
    signal setup_half_frame_z : signed(22 downto 0) := (others => '0'); -- s23f18
    signal setup_half_unit_x_n1310_neg : unsigned(22 downto 0) := (others => '0');
    signal setup_half_unit_x_n1310 : unsigned(22 downto 0) := (others => '0'); -- u23f18
    signal setup_half_unit_x_n1312 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1313 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1314 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1315 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1316 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1317 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1318 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1319 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1320 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1321 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1322 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1323 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1324 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1325 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1326 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1327 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1328 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1329 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1330 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1331 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1332 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1333 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_unit_x_n1334 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_half_unit_x_n1335 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_half_unit_x_n1336 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_half_unit_x_n1337 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_half_unit_x_n1338 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_half_unit_x_n1339 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal setup_half_unit_x_n1340 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_half_unit_x_n1341 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_half_unit_x_n1342 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_half_unit_x_n1343 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_half_unit_x_n1344 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_half_unit_x_n1345 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal setup_half_unit_x_n1346 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_half_unit_x_n1347 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_half_unit_x_n1348 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_half_unit_x_n1349 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_half_unit_x_n1350 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_half_unit_x_n1351 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_half_unit_x_n1352 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_x_n1355 : unsigned(43 downto 0) := (others => '0'); -- u44f0
    signal setup_half_unit_x_n1356 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_half_unit_x_n1357 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_x_n1358 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_x_n1359 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1360 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_x_n1361 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1367 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1520 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1522 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1526_neg : unsigned(22 downto 0) := (others => '0');
    signal setup_half_unit_y_n1526 : unsigned(22 downto 0) := (others => '0'); -- u23f18
    signal setup_half_unit_y_n1527 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1528 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1529 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1530 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1531 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1532 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1533 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1534 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1535 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1536 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1537 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1538 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1539 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1540 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1541 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1542 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1543 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1544 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1545 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1546 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1547 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1548 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_unit_y_n1549 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_half_unit_y_n1550 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_half_unit_y_n1551 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_half_unit_y_n1552 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_half_unit_y_n1553 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_half_unit_y_n1554 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal setup_half_unit_y_n1555 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_half_unit_y_n1556 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_half_unit_y_n1557 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_half_unit_y_n1558 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_half_unit_y_n1559 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_half_unit_y_n1560 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal setup_half_unit_y_n1561 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_half_unit_y_n1562 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_half_unit_y_n1563 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_half_unit_y_n1564 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_half_unit_y_n1565 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_half_unit_y_n1566 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_half_unit_y_n1567 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_y_n1570 : unsigned(43 downto 0) := (others => '0'); -- u44f0
    signal setup_half_unit_y_n1571 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_half_unit_y_n1572 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_y_n1573 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_y_n1574 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1575 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_y_n1576 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1582 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1734 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1736 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1740_neg : unsigned(22 downto 0) := (others => '0');
    signal setup_half_unit_z_n1740 : unsigned(22 downto 0) := (others => '0'); -- u23f18
    signal setup_half_unit_z_n1741 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1742 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1743 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1744 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1745 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1746 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1747 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1748 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1749 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1750 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1751 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1752 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1753 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1754 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1755 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1756 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1757 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1758 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1759 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1760 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1761 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1762 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_unit_z_n1763 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_half_unit_z_n1764 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_half_unit_z_n1765 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_half_unit_z_n1766 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_half_unit_z_n1767 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_half_unit_z_n1768 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal setup_half_unit_z_n1769 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_half_unit_z_n1770 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_half_unit_z_n1771 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_half_unit_z_n1772 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_half_unit_z_n1773 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_half_unit_z_n1774 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal setup_half_unit_z_n1775 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_half_unit_z_n1776 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_half_unit_z_n1777 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_half_unit_z_n1778 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_half_unit_z_n1779 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_half_unit_z_n1780 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_half_unit_z_n1781 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_z_n1784 : unsigned(43 downto 0) := (others => '0'); -- u44f0
    signal setup_half_unit_z_n1785 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_half_unit_z_n1786 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_z_n1787 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_z_n1788 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1789 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_z_n1790 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1796 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1948 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1950 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n1964 : signed(2 downto 0) := (others => '0'); -- s3f0
    signal setup_bump_length_n1965 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n1966 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n1970 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_bump_length_n1971 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n1972 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_bump_length_n1973 : signed(4 downto 0) := (others => '0'); -- s5f0
    signal setup_bump_length_n1974 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n1975 : signed(4 downto 0) := (others => '0'); -- s5f0
    signal setup_bump_length_n1976 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_bump_length_n1977 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n1978 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n1982 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_bump_length_n1983 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_bump_length_n1984 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_bump_length_n1985 : signed(5 downto 0) := (others => '0'); -- s6f0
    signal setup_bump_length_n1986 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n1987 : signed(5 downto 0) := (others => '0'); -- s6f0
    signal setup_bump_length_n1988 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_bump_length_n1989 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n1990 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_bump_length_n1994 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_bump_length_n1995 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_bump_length_n1996 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_bump_length_n1997 : signed(6 downto 0) := (others => '0'); -- s7f0
    signal setup_bump_length_n1998 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n1999 : signed(6 downto 0) := (others => '0'); -- s7f0
    signal setup_bump_length_n2000 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_bump_length_n2001 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2002 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_bump_length_n2006 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_bump_length_n2007 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_bump_length_n2008 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_light_frame_x_s3 : signed(22 downto 0) := (others => '0'); -- s23f18
    signal setup_light_frame_y_s3 : signed(22 downto 0) := (others => '0'); -- s23f18
    signal setup_light_frame_z_s3 : signed(22 downto 0) := (others => '0'); -- s23f18
    signal setup_light_length_n327_s3 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_unit_x_n385_s3 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_x_n395_s3 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n396_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n402_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n555_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n557_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n602_s3 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_y_n611_s3 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n617_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n769_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n771_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n816_s3 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_z_n825_s3 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n831_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n983_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n985_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_frame_x_s3 : signed(22 downto 0) := (others => '0'); -- s23f18
    signal setup_half_frame_y_s3 : signed(22 downto 0) := (others => '0'); -- s23f18
    signal setup_half_frame_z_s3 : signed(22 downto 0) := (others => '0'); -- s23f18
    signal setup_half_unit_x_n1352_s3 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_x_n1361_s3 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1367_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1520_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1522_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1567_s3 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_y_n1576_s3 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1582_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1734_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1736_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1781_s3 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_z_n1790_s3 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1796_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1948_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1950_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2002_s3 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_bump_length_n2006_s3 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_bump_length_n2008_s3 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_bump_length_n2017_s3 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2029_s3 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2041_s3 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2053_s3 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2065_s3 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2077_s3 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2089_s3 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2101_s3 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2113_s3 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2125_s3 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2137_s3 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2149_s3 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2161_s3 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2173_s3 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_unit_x_n2251_s3 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_x_n2259_s3 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2417_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2419_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2458_s3 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_y_n2466_s3 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2623_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2625_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2664_s3 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_z_n2672_s3 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2829_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2831_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s3 : std_logic;
    -- stage 3
    signal setup_light_n36 : signed(45 downto 0) := (others => '0'); -- s46f36
    signal setup_light_n37 : signed(45 downto 0) := (others => '0'); -- s46f36
    signal setup_light_n38 : signed(45 downto 0) := (others => '0'); -- s46f36
    signal setup_half_n1007 : signed(45 downto 0) := (others => '0'); -- s46f36
    signal setup_half_n1008 : signed(45 downto 0) := (others => '0'); -- s46f36
    signal setup_half_n1009 : signed(45 downto 0) := (others => '0'); -- s46f36
    signal setup_bump_length_n2009 : signed(7 downto 0) := (others => '0'); -- s8f0
    signal setup_bump_length_n2010 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2011 : signed(7 downto 0) := (others => '0'); -- s8f0
    signal setup_bump_length_n2012 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_bump_length_n2013 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2014 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_bump_length_n2018 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal setup_bump_length_n2019 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_bump_length_n2020 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_bump_length_n2021 : signed(8 downto 0) := (others => '0'); -- s9f0
    signal setup_bump_length_n2022 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2023 : signed(8 downto 0) := (others => '0'); -- s9f0
    signal setup_bump_length_n2024 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_bump_length_n2025 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2026 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_bump_length_n2030 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_bump_length_n2031 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_bump_length_n2032 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal setup_bump_length_n2033 : signed(9 downto 0) := (others => '0'); -- s10f0
    signal setup_bump_length_n2034 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2035 : signed(9 downto 0) := (others => '0'); -- s10f0
    signal setup_bump_length_n2036 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal setup_bump_length_n2037 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2038 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_bump_length_n2042 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_bump_length_n2043 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal setup_bump_length_n2044 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_light_n36_s4 : signed(45 downto 0) := (others => '0'); -- s46f36
    signal setup_light_n37_s4 : signed(45 downto 0) := (others => '0'); -- s46f36
    signal setup_light_n38_s4 : signed(45 downto 0) := (others => '0'); -- s46f36
    signal setup_light_length_n327_s4 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_unit_x_n385_s4 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_x_n395_s4 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n396_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n402_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n555_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n557_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n602_s4 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_y_n611_s4 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n617_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n769_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n771_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n816_s4 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_z_n825_s4 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n831_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n983_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n985_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_n1007_s4 : signed(45 downto 0) := (others => '0'); -- s46f36
    signal setup_half_n1008_s4 : signed(45 downto 0) := (others => '0'); -- s46f36
    signal setup_half_n1009_s4 : signed(45 downto 0) := (others => '0'); -- s46f36
    signal setup_half_unit_x_n1352_s4 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_x_n1361_s4 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1367_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1520_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1522_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1567_s4 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_y_n1576_s4 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1582_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1734_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1736_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1781_s4 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_z_n1790_s4 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1796_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1948_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1950_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2038_s4 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_bump_length_n2042_s4 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_bump_length_n2044_s4 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_bump_length_n2053_s4 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2065_s4 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2077_s4 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2089_s4 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2101_s4 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2113_s4 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2125_s4 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2137_s4 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2149_s4 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2161_s4 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2173_s4 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_unit_x_n2251_s4 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_x_n2259_s4 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2417_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2419_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2458_s4 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_y_n2466_s4 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2623_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2625_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2664_s4 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_z_n2672_s4 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2829_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2831_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s4 : std_logic;
    -- stage 4
    signal setup_light_n39 : signed(46 downto 0) := (others => '0'); -- s47f36
    signal setup_light_n40 : signed(47 downto 0) := (others => '0'); -- s48f36
    signal setup_light_square_under : unsigned(0 downto 0) := (others => '0');
    signal setup_light_square : unsigned(46 downto 0) := (others => '0'); -- u47f36
    signal setup_light_length_n44 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n45 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n51 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n52 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n53 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n63 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n64 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n65 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n75 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n76 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n77 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n87 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n88 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n89 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n99 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n100 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n101 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n111 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n112 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n113 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n123 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n124 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n125 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n135 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n136 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n137 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n147 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n148 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n149 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n159 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n160 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n161 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n171 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n172 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n173 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n183 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n184 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n185 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n195 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n196 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n197 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n207 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n208 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n209 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n219 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n220 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n221 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n231 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n232 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n233 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n243 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n244 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n245 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n255 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n256 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n257 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n267 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n268 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n269 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n279 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n280 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n281 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n291 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n292 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n293 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n303 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n304 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n305 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n315 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n316 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n317 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_n1010 : signed(46 downto 0) := (others => '0'); -- s47f36
    signal setup_half_n1011 : signed(47 downto 0) := (others => '0'); -- s48f36
    signal setup_half_square_under : unsigned(0 downto 0) := (others => '0');
    signal setup_half_square : unsigned(46 downto 0) := (others => '0'); -- u47f36
    signal setup_half_length_n1013 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1014 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1020 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1021 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1022 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1032 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1033 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1034 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1044 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1045 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1046 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1056 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1057 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1058 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1068 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1069 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1070 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1080 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1081 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1082 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1092 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1093 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1094 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1104 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1105 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1106 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1116 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1117 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1118 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1128 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1129 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1130 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1140 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1141 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1142 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1152 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1153 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1154 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1164 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1165 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1166 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1176 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1177 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1178 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1188 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1189 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1190 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1200 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1201 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1202 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1212 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1213 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1214 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1224 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1225 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1226 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1236 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1237 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1238 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1248 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1249 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1250 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1260 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1261 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1262 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1272 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1273 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1274 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1284 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1285 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1286 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2045 : signed(10 downto 0) := (others => '0'); -- s11f0
    signal setup_bump_length_n2046 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2047 : signed(10 downto 0) := (others => '0'); -- s11f0
    signal setup_bump_length_n2048 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_bump_length_n2049 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2050 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal setup_bump_length_n2054 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_bump_length_n2055 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_bump_length_n2056 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_bump_length_n2057 : signed(11 downto 0) := (others => '0'); -- s12f0
    signal setup_bump_length_n2058 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2059 : signed(11 downto 0) := (others => '0'); -- s12f0
    signal setup_bump_length_n2060 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_bump_length_n2061 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2062 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_bump_length_n2066 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_bump_length_n2067 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_bump_length_n2068 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_bump_length_n2069 : signed(12 downto 0) := (others => '0'); -- s13f0
    signal setup_bump_length_n2070 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2071 : signed(12 downto 0) := (others => '0'); -- s13f0
    signal setup_bump_length_n2072 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_bump_length_n2073 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2074 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_bump_length_n2078 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_bump_length_n2079 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_bump_length_n2080 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_light_length_n45_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n53_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n65_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n77_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n89_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n101_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n113_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n125_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n137_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n149_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n161_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n173_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n185_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n197_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n209_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n221_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n233_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n245_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n257_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n269_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n281_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n293_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n305_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n317_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n327_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_unit_x_n385_s5 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_x_n395_s5 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n396_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n402_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n555_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n557_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n602_s5 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_y_n611_s5 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n617_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n769_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n771_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n816_s5 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_z_n825_s5 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n831_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n983_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n985_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1014_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1022_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1034_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1046_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1058_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1070_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1082_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1094_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1106_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1118_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1130_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1142_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1154_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1166_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1178_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1190_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1202_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1214_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1226_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1238_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1250_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1262_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1274_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1286_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_unit_x_n1352_s5 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_x_n1361_s5 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1367_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1520_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1522_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1567_s5 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_y_n1576_s5 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1582_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1734_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1736_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1781_s5 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_z_n1790_s5 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1796_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1948_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1950_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2074_s5 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_bump_length_n2078_s5 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_bump_length_n2080_s5 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_bump_length_n2089_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2101_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2113_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2125_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2137_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2149_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2161_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2173_s5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_unit_x_n2251_s5 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_x_n2259_s5 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2417_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2419_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2458_s5 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_y_n2466_s5 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2623_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2625_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2664_s5 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_z_n2672_s5 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2829_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2831_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s5 : std_logic;
    -- stage 5
    signal setup_light_length_n46 : signed(2 downto 0) := (others => '0'); -- s3f0
    signal setup_light_length_n47 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n48 : signed(2 downto 0) := (others => '0'); -- s3f0
    signal setup_light_length_n49 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n50 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n54 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_light_length_n55 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n56 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_light_length_n57 : signed(4 downto 0) := (others => '0'); -- s5f0
    signal setup_light_length_n58 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n59 : signed(4 downto 0) := (others => '0'); -- s5f0
    signal setup_light_length_n60 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_light_length_n61 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n62 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n66 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_light_length_n67 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_light_length_n68 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_light_length_n69 : signed(5 downto 0) := (others => '0'); -- s6f0
    signal setup_light_length_n70 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n71 : signed(5 downto 0) := (others => '0'); -- s6f0
    signal setup_light_length_n72 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_light_length_n73 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n74 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_light_length_n78 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_light_length_n79 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_light_length_n80 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_light_length_n81 : signed(6 downto 0) := (others => '0'); -- s7f0
    signal setup_light_length_n82 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1015 : signed(2 downto 0) := (others => '0'); -- s3f0
    signal setup_half_length_n1016 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1017 : signed(2 downto 0) := (others => '0'); -- s3f0
    signal setup_half_length_n1018 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1019 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1023 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_half_length_n1024 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1025 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_half_length_n1026 : signed(4 downto 0) := (others => '0'); -- s5f0
    signal setup_half_length_n1027 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1028 : signed(4 downto 0) := (others => '0'); -- s5f0
    signal setup_half_length_n1029 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_half_length_n1030 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1031 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1035 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_half_length_n1036 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_half_length_n1037 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_half_length_n1038 : signed(5 downto 0) := (others => '0'); -- s6f0
    signal setup_half_length_n1039 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1040 : signed(5 downto 0) := (others => '0'); -- s6f0
    signal setup_half_length_n1041 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_half_length_n1042 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1043 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_half_length_n1047 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_half_length_n1048 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_half_length_n1049 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_half_length_n1050 : signed(6 downto 0) := (others => '0'); -- s7f0
    signal setup_half_length_n1051 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2081 : signed(13 downto 0) := (others => '0'); -- s14f0
    signal setup_bump_length_n2082 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2083 : signed(13 downto 0) := (others => '0'); -- s14f0
    signal setup_bump_length_n2084 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_bump_length_n2085 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2086 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_bump_length_n2090 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal setup_bump_length_n2091 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_bump_length_n2092 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_bump_length_n2093 : signed(14 downto 0) := (others => '0'); -- s15f0
    signal setup_bump_length_n2094 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2095 : signed(14 downto 0) := (others => '0'); -- s15f0
    signal setup_bump_length_n2096 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_bump_length_n2097 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2098 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_bump_length_n2102 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_bump_length_n2103 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_bump_length_n2104 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal setup_bump_length_n2105 : signed(15 downto 0) := (others => '0'); -- s16f0
    signal setup_bump_length_n2106 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2107 : signed(15 downto 0) := (others => '0'); -- s16f0
    signal setup_bump_length_n2108 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal setup_bump_length_n2109 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2110 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_bump_length_n2114 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_bump_length_n2115 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal setup_bump_length_n2116 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_light_length_n74_s6 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_light_length_n78_s6 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_light_length_n81_s6 : signed(6 downto 0) := (others => '0'); -- s7f0
    signal setup_light_length_n82_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n89_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n101_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n113_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n125_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n137_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n149_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n161_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n173_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n185_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n197_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n209_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n221_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n233_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n245_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n257_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n269_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n281_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n293_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n305_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n317_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n327_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_unit_x_n385_s6 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_x_n395_s6 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n396_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n402_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n555_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n557_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n602_s6 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_y_n611_s6 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n617_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n769_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n771_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n816_s6 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_z_n825_s6 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n831_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n983_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n985_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1043_s6 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_half_length_n1047_s6 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_half_length_n1050_s6 : signed(6 downto 0) := (others => '0'); -- s7f0
    signal setup_half_length_n1051_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1058_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1070_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1082_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1094_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1106_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1118_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1130_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1142_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1154_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1166_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1178_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1190_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1202_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1214_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1226_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1238_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1250_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1262_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1274_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1286_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_unit_x_n1352_s6 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_x_n1361_s6 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1367_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1520_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1522_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1567_s6 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_y_n1576_s6 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1582_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1734_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1736_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1781_s6 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_z_n1790_s6 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1796_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1948_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1950_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2110_s6 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_bump_length_n2114_s6 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_bump_length_n2116_s6 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_bump_length_n2125_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2137_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2149_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2161_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2173_s6 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_unit_x_n2251_s6 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_x_n2259_s6 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2417_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2419_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2458_s6 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_y_n2466_s6 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2623_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2625_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2664_s6 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_z_n2672_s6 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2829_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2831_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s6 : std_logic;
    -- stage 6
    signal setup_light_length_n83 : signed(6 downto 0) := (others => '0'); -- s7f0
    signal setup_light_length_n84 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_light_length_n85 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n86 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_light_length_n90 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_light_length_n91 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_light_length_n92 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_light_length_n93 : signed(7 downto 0) := (others => '0'); -- s8f0
    signal setup_light_length_n94 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n95 : signed(7 downto 0) := (others => '0'); -- s8f0
    signal setup_light_length_n96 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_light_length_n97 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n98 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_light_length_n102 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal setup_light_length_n103 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_light_length_n104 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_light_length_n105 : signed(8 downto 0) := (others => '0'); -- s9f0
    signal setup_light_length_n106 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n107 : signed(8 downto 0) := (others => '0'); -- s9f0
    signal setup_light_length_n108 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_light_length_n109 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n110 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_light_length_n114 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_light_length_n115 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_light_length_n116 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal setup_light_length_n117 : signed(9 downto 0) := (others => '0'); -- s10f0
    signal setup_light_length_n118 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n119 : signed(9 downto 0) := (others => '0'); -- s10f0
    signal setup_light_length_n120 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal setup_light_length_n121 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n122 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_light_length_n126 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_light_length_n127 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal setup_light_length_n128 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_half_length_n1052 : signed(6 downto 0) := (others => '0'); -- s7f0
    signal setup_half_length_n1053 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_half_length_n1054 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1055 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_half_length_n1059 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_half_length_n1060 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_half_length_n1061 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_half_length_n1062 : signed(7 downto 0) := (others => '0'); -- s8f0
    signal setup_half_length_n1063 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1064 : signed(7 downto 0) := (others => '0'); -- s8f0
    signal setup_half_length_n1065 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_half_length_n1066 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1067 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_half_length_n1071 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal setup_half_length_n1072 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_half_length_n1073 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_half_length_n1074 : signed(8 downto 0) := (others => '0'); -- s9f0
    signal setup_half_length_n1075 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1076 : signed(8 downto 0) := (others => '0'); -- s9f0
    signal setup_half_length_n1077 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_half_length_n1078 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1079 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_half_length_n1083 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_half_length_n1084 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_half_length_n1085 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal setup_half_length_n1086 : signed(9 downto 0) := (others => '0'); -- s10f0
    signal setup_half_length_n1087 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1088 : signed(9 downto 0) := (others => '0'); -- s10f0
    signal setup_half_length_n1089 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal setup_half_length_n1090 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1091 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_half_length_n1095 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_half_length_n1096 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal setup_half_length_n1097 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_bump_length_n2117 : signed(16 downto 0) := (others => '0'); -- s17f0
    signal setup_bump_length_n2118 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2119 : signed(16 downto 0) := (others => '0'); -- s17f0
    signal setup_bump_length_n2120 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_bump_length_n2121 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2122 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal setup_bump_length_n2126 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_bump_length_n2127 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_bump_length_n2128 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_bump_length_n2129 : signed(17 downto 0) := (others => '0'); -- s18f0
    signal setup_bump_length_n2130 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2131 : signed(17 downto 0) := (others => '0'); -- s18f0
    signal setup_bump_length_n2132 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_bump_length_n2133 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2134 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_bump_length_n2138 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_length_n2139 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_bump_length_n2140 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_bump_length_n2141 : signed(18 downto 0) := (others => '0'); -- s19f0
    signal setup_bump_length_n2142 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n122_s7 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_light_length_n126_s7 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_light_length_n128_s7 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_light_length_n137_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n149_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n161_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n173_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n185_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n197_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n209_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n221_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n233_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n245_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n257_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n269_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n281_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n293_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n305_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n317_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n327_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_unit_x_n385_s7 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_x_n395_s7 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n396_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n402_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n555_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n557_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n602_s7 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_y_n611_s7 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n617_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n769_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n771_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n816_s7 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_z_n825_s7 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n831_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n983_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n985_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1091_s7 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_half_length_n1095_s7 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_half_length_n1097_s7 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_half_length_n1106_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1118_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1130_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1142_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1154_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1166_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1178_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1190_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1202_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1214_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1226_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1238_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1250_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1262_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1274_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1286_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_unit_x_n1352_s7 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_x_n1361_s7 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1367_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1520_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1522_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1567_s7 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_y_n1576_s7 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1582_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1734_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1736_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1781_s7 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_z_n1790_s7 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1796_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1948_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1950_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2134_s7 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_bump_length_n2138_s7 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_length_n2141_s7 : signed(18 downto 0) := (others => '0'); -- s19f0
    signal setup_bump_length_n2142_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2149_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2161_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_length_n2173_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_unit_x_n2251_s7 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_x_n2259_s7 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2417_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2419_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2458_s7 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_y_n2466_s7 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2623_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2625_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2664_s7 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_z_n2672_s7 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2829_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2831_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s7 : std_logic;
    -- stage 7
    signal setup_light_length_n129 : signed(10 downto 0) := (others => '0'); -- s11f0
    signal setup_light_length_n130 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n131 : signed(10 downto 0) := (others => '0'); -- s11f0
    signal setup_light_length_n132 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_light_length_n133 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n134 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal setup_light_length_n138 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_light_length_n139 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_light_length_n140 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_light_length_n141 : signed(11 downto 0) := (others => '0'); -- s12f0
    signal setup_light_length_n142 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n143 : signed(11 downto 0) := (others => '0'); -- s12f0
    signal setup_light_length_n144 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_light_length_n145 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n146 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_light_length_n150 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_light_length_n151 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_light_length_n152 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_light_length_n153 : signed(12 downto 0) := (others => '0'); -- s13f0
    signal setup_light_length_n154 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n155 : signed(12 downto 0) := (others => '0'); -- s13f0
    signal setup_light_length_n156 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_light_length_n157 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n158 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_light_length_n162 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_light_length_n163 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_light_length_n164 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_half_length_n1098 : signed(10 downto 0) := (others => '0'); -- s11f0
    signal setup_half_length_n1099 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1100 : signed(10 downto 0) := (others => '0'); -- s11f0
    signal setup_half_length_n1101 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_half_length_n1102 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1103 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal setup_half_length_n1107 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_half_length_n1108 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_half_length_n1109 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_half_length_n1110 : signed(11 downto 0) := (others => '0'); -- s12f0
    signal setup_half_length_n1111 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1112 : signed(11 downto 0) := (others => '0'); -- s12f0
    signal setup_half_length_n1113 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_half_length_n1114 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1115 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_half_length_n1119 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_half_length_n1120 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_half_length_n1121 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_half_length_n1122 : signed(12 downto 0) := (others => '0'); -- s13f0
    signal setup_half_length_n1123 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1124 : signed(12 downto 0) := (others => '0'); -- s13f0
    signal setup_half_length_n1125 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_half_length_n1126 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1127 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_half_length_n1131 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_half_length_n1132 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_half_length_n1133 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_bump_length_n2143 : signed(18 downto 0) := (others => '0'); -- s19f0
    signal setup_bump_length_n2144 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_bump_length_n2145 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2146 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_bump_length_n2150 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_bump_length_n2151 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_bump_length_n2152 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_length_n2153 : signed(19 downto 0) := (others => '0'); -- s20f0
    signal setup_bump_length_n2154 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2155 : signed(19 downto 0) := (others => '0'); -- s20f0
    signal setup_bump_length_n2156 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_length_n2157 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2158 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_bump_length_n2162 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_bump_length_n2163 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_length_n2164 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_bump_length_n2165 : signed(20 downto 0) := (others => '0'); -- s21f0
    signal setup_bump_length_n2166 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2167 : signed(20 downto 0) := (others => '0'); -- s21f0
    signal setup_bump_length_n2168 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_bump_length_n2169 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2170 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_length_n2174 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_bump_length_n2175 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_bump_length_n2176 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_light_length_n158_s8 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_light_length_n162_s8 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_light_length_n164_s8 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_light_length_n173_s8 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n185_s8 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n197_s8 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n209_s8 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n221_s8 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n233_s8 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n245_s8 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n257_s8 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n269_s8 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n281_s8 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n293_s8 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n305_s8 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n317_s8 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n327_s8 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_unit_x_n385_s8 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_x_n395_s8 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n396_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n402_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n555_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n557_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n602_s8 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_y_n611_s8 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n617_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n769_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n771_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n816_s8 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_z_n825_s8 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n831_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n983_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n985_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1127_s8 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_half_length_n1131_s8 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_half_length_n1133_s8 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_half_length_n1142_s8 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1154_s8 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1166_s8 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1178_s8 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1190_s8 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1202_s8 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1214_s8 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1226_s8 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1238_s8 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1250_s8 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1262_s8 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1274_s8 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1286_s8 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_unit_x_n1352_s8 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_x_n1361_s8 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1367_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1520_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1522_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1567_s8 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_y_n1576_s8 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1582_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1734_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1736_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1781_s8 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_z_n1790_s8 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1796_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1948_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1950_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2170_s8 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_length_n2174_s8 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_bump_length_n2176_s8 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_bump_unit_x_n2251_s8 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_x_n2259_s8 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2417_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2419_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2458_s8 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_y_n2466_s8 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2623_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2625_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2664_s8 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_z_n2672_s8 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2829_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2831_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s8 : std_logic;
    -- stage 8
    signal setup_light_length_n165 : signed(13 downto 0) := (others => '0'); -- s14f0
    signal setup_light_length_n166 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n167 : signed(13 downto 0) := (others => '0'); -- s14f0
    signal setup_light_length_n168 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_light_length_n169 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n170 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_light_length_n174 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal setup_light_length_n175 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_light_length_n176 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_light_length_n177 : signed(14 downto 0) := (others => '0'); -- s15f0
    signal setup_light_length_n178 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n179 : signed(14 downto 0) := (others => '0'); -- s15f0
    signal setup_light_length_n180 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_light_length_n181 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n182 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_light_length_n186 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_light_length_n187 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_light_length_n188 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal setup_light_length_n189 : signed(15 downto 0) := (others => '0'); -- s16f0
    signal setup_light_length_n190 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n191 : signed(15 downto 0) := (others => '0'); -- s16f0
    signal setup_light_length_n192 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal setup_light_length_n193 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n194 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_light_length_n198 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_light_length_n199 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal setup_light_length_n200 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_half_length_n1134 : signed(13 downto 0) := (others => '0'); -- s14f0
    signal setup_half_length_n1135 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1136 : signed(13 downto 0) := (others => '0'); -- s14f0
    signal setup_half_length_n1137 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_half_length_n1138 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1139 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_half_length_n1143 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal setup_half_length_n1144 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_half_length_n1145 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_half_length_n1146 : signed(14 downto 0) := (others => '0'); -- s15f0
    signal setup_half_length_n1147 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1148 : signed(14 downto 0) := (others => '0'); -- s15f0
    signal setup_half_length_n1149 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_half_length_n1150 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1151 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_half_length_n1155 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_half_length_n1156 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_half_length_n1157 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal setup_half_length_n1158 : signed(15 downto 0) := (others => '0'); -- s16f0
    signal setup_half_length_n1159 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1160 : signed(15 downto 0) := (others => '0'); -- s16f0
    signal setup_half_length_n1161 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal setup_half_length_n1162 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1163 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_half_length_n1167 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_half_length_n1168 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal setup_half_length_n1169 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_bump_length_n2177 : signed(21 downto 0) := (others => '0'); -- s22f0
    signal setup_bump_length_n2178 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2179 : signed(21 downto 0) := (others => '0'); -- s22f0
    signal setup_bump_length_n2180 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_bump_length_n2181 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2182 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_bump_length_n2183 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal setup_bump_length_n2184 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_bump_length_n2185 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_bump_length_n2186 : signed(22 downto 0) := (others => '0'); -- s23f0
    signal setup_bump_length_n2187 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2188 : signed(22 downto 0) := (others => '0'); -- s23f0
    signal setup_bump_length_n2189 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_bump_length_n2190 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2191 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_bump_length_n2192 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_bump_length_n2193 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_bump_length_n2194 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal setup_light_length_n194_s9 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_light_length_n198_s9 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_light_length_n200_s9 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_light_length_n209_s9 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n221_s9 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n233_s9 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n245_s9 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n257_s9 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n269_s9 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n281_s9 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n293_s9 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n305_s9 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n317_s9 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n327_s9 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_unit_x_n385_s9 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_x_n395_s9 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n396_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n402_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n555_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n557_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n602_s9 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_y_n611_s9 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n617_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n769_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n771_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n816_s9 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_z_n825_s9 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n831_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n983_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n985_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1163_s9 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_half_length_n1167_s9 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_half_length_n1169_s9 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_half_length_n1178_s9 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1190_s9 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1202_s9 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1214_s9 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1226_s9 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1238_s9 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1250_s9 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1262_s9 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1274_s9 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1286_s9 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_unit_x_n1352_s9 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_x_n1361_s9 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1367_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1520_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1522_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1567_s9 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_y_n1576_s9 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1582_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1734_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1736_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1781_s9 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_z_n1790_s9 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1796_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1948_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1950_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2191_s9 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_bump_length_n2192_s9 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_bump_length_n2194_s9 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal setup_bump_unit_x_n2251_s9 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_x_n2259_s9 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2417_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2419_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2458_s9 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_y_n2466_s9 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2623_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2625_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2664_s9 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_z_n2672_s9 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2829_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2831_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s9 : std_logic;
    -- stage 9
    signal setup_light_length_n201 : signed(16 downto 0) := (others => '0'); -- s17f0
    signal setup_light_length_n202 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n203 : signed(16 downto 0) := (others => '0'); -- s17f0
    signal setup_light_length_n204 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_light_length_n205 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n206 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal setup_light_length_n210 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_light_length_n211 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_light_length_n212 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_light_length_n213 : signed(17 downto 0) := (others => '0'); -- s18f0
    signal setup_light_length_n214 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n215 : signed(17 downto 0) := (others => '0'); -- s18f0
    signal setup_light_length_n216 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_light_length_n217 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n218 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_light_length_n222 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_light_length_n223 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_light_length_n224 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_light_length_n225 : signed(18 downto 0) := (others => '0'); -- s19f0
    signal setup_light_length_n226 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1170 : signed(16 downto 0) := (others => '0'); -- s17f0
    signal setup_half_length_n1171 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1172 : signed(16 downto 0) := (others => '0'); -- s17f0
    signal setup_half_length_n1173 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_half_length_n1174 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1175 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal setup_half_length_n1179 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_half_length_n1180 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_half_length_n1181 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_half_length_n1182 : signed(17 downto 0) := (others => '0'); -- s18f0
    signal setup_half_length_n1183 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1184 : signed(17 downto 0) := (others => '0'); -- s18f0
    signal setup_half_length_n1185 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_half_length_n1186 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1187 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_half_length_n1191 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_half_length_n1192 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_half_length_n1193 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_half_length_n1194 : signed(18 downto 0) := (others => '0'); -- s19f0
    signal setup_half_length_n1195 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2195 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_length_n2196 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2197 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_length_n2198 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal setup_bump_length_n2199 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2200 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_bump_length_n2201 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_length_n2202 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal setup_bump_length_n2203 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_bump_length_n2204 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_length_n2205 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2206 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_length_n2207 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_bump_length_n2208 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2209 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal setup_light_length_n218_s10 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_light_length_n222_s10 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_light_length_n225_s10 : signed(18 downto 0) := (others => '0'); -- s19f0
    signal setup_light_length_n226_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n233_s10 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n245_s10 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n257_s10 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n269_s10 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n281_s10 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n293_s10 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n305_s10 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n317_s10 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n327_s10 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_unit_x_n385_s10 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_x_n395_s10 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n396_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n402_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n555_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n557_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n602_s10 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_y_n611_s10 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n617_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n769_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n771_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n816_s10 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_z_n825_s10 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n831_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n983_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n985_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1187_s10 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_half_length_n1191_s10 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_half_length_n1194_s10 : signed(18 downto 0) := (others => '0'); -- s19f0
    signal setup_half_length_n1195_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1202_s10 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1214_s10 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1226_s10 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1238_s10 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1250_s10 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1262_s10 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1274_s10 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1286_s10 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_unit_x_n1352_s10 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_x_n1361_s10 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1367_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1520_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1522_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1567_s10 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_y_n1576_s10 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1582_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1734_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1736_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1781_s10 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_z_n1790_s10 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1796_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1948_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1950_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2207_s10 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_bump_length_n2209_s10 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal setup_bump_unit_x_n2251_s10 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_x_n2259_s10 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2417_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2419_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2458_s10 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_y_n2466_s10 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2623_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2625_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2664_s10 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_z_n2672_s10 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2829_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2831_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s10 : std_logic;
    -- stage 10
    signal setup_light_length_n227 : signed(18 downto 0) := (others => '0'); -- s19f0
    signal setup_light_length_n228 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_light_length_n229 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n230 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_light_length_n234 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_light_length_n235 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_light_length_n236 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_light_length_n237 : signed(19 downto 0) := (others => '0'); -- s20f0
    signal setup_light_length_n238 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n239 : signed(19 downto 0) := (others => '0'); -- s20f0
    signal setup_light_length_n240 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_light_length_n241 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n242 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_light_length_n246 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_light_length_n247 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_light_length_n248 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_light_length_n249 : signed(20 downto 0) := (others => '0'); -- s21f0
    signal setup_light_length_n250 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n251 : signed(20 downto 0) := (others => '0'); -- s21f0
    signal setup_light_length_n252 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_light_length_n253 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n254 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_light_length_n258 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_length_n259 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_light_length_n260 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_half_length_n1196 : signed(18 downto 0) := (others => '0'); -- s19f0
    signal setup_half_length_n1197 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_half_length_n1198 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1199 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_half_length_n1203 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_half_length_n1204 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_half_length_n1205 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_half_length_n1206 : signed(19 downto 0) := (others => '0'); -- s20f0
    signal setup_half_length_n1207 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1208 : signed(19 downto 0) := (others => '0'); -- s20f0
    signal setup_half_length_n1209 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_half_length_n1210 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1211 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_half_length_n1215 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_half_length_n1216 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_half_length_n1217 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_half_length_n1218 : signed(20 downto 0) := (others => '0'); -- s21f0
    signal setup_half_length_n1219 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1220 : signed(20 downto 0) := (others => '0'); -- s21f0
    signal setup_half_length_n1221 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_half_length_n1222 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1223 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_half_length_n1227 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_length_n1228 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_half_length_n1229 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_bump_length_n2210 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2211 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_length_n2212 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_bump_length_n2213 : unsigned(22 downto 0) := (others => '0'); -- u23f20
    signal setup_bump_length_length_sum : unsigned(23 downto 0) := (others => '0');
    signal setup_bump_length_length_cut : unsigned(21 downto 0) := (others => '0');
    signal setup_bump_length_length : unsigned(22 downto 0) := (others => '0'); -- u23f18
    signal setup_bump_unit_x_n2216 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_bump_unit_x_n2252 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2260_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_x_n2260 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_x_n2261 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_x_n2262 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2264 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_x_n2265 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_x_n2266 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2414 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2459 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2467_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_y_n2467 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_y_n2468 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_y_n2469 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2471 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_y_n2472 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_y_n2473 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2665 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2673_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_z_n2673 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_z_n2674 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_z_n2675 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2677 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_z_n2678 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_z_n2679 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_length_n254_s11 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_light_length_n258_s11 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_length_n260_s11 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_light_length_n269_s11 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n281_s11 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n293_s11 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n305_s11 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n317_s11 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n327_s11 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_unit_x_n385_s11 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_x_n395_s11 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n396_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n402_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n555_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n557_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n602_s11 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_y_n611_s11 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n617_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n769_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n771_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n816_s11 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_z_n825_s11 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n831_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n983_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n985_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1223_s11 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_half_length_n1227_s11 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_length_n1229_s11 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_half_length_n1238_s11 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1250_s11 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1262_s11 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1274_s11 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1286_s11 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_unit_x_n1352_s11 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_x_n1361_s11 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1367_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1520_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1522_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1567_s11 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_y_n1576_s11 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1582_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1734_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1736_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1781_s11 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_z_n1790_s11 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1796_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1948_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1950_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2216_s11 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_bump_unit_x_n2252_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2262_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2266_s11 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2414_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2417_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2419_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2459_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2469_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2473_s11 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2623_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2625_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2665_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2675_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2679_s11 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2829_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2831_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s11 : std_logic;
    -- stage 11
    signal setup_light_length_n261 : signed(21 downto 0) := (others => '0'); -- s22f0
    signal setup_light_length_n262 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n263 : signed(21 downto 0) := (others => '0'); -- s22f0
    signal setup_light_length_n264 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_light_length_n265 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n266 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_light_length_n270 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal setup_light_length_n271 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_light_length_n272 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_length_n273 : signed(22 downto 0) := (others => '0'); -- s23f0
    signal setup_light_length_n274 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n275 : signed(22 downto 0) := (others => '0'); -- s23f0
    signal setup_light_length_n276 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_length_n277 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n278 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_light_length_n282 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_light_length_n283 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_length_n284 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal setup_half_length_n1230 : signed(21 downto 0) := (others => '0'); -- s22f0
    signal setup_half_length_n1231 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1232 : signed(21 downto 0) := (others => '0'); -- s22f0
    signal setup_half_length_n1233 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_half_length_n1234 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1235 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_half_length_n1239 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal setup_half_length_n1240 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_half_length_n1241 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_length_n1242 : signed(22 downto 0) := (others => '0'); -- s23f0
    signal setup_half_length_n1243 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1244 : signed(22 downto 0) := (others => '0'); -- s23f0
    signal setup_half_length_n1245 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_length_n1246 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1247 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_half_length_n1251 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_half_length_n1252 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_length_n1253 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal setup_bump_unit_x_n2253 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2263 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2267_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_x_n2267 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_x_n2268 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_x_n2269 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2270 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2271 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_x_n2272 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_x_n2273 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2274_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_x_n2274 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_x_n2275 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_x_n2276 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2277 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2278 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_x_n2279 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_x_n2280 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2394 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_unit_x_n2395 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_bump_unit_x_n2415 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2460 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2470 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2474_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_y_n2474 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_y_n2475 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_y_n2476 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2477 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2478 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_y_n2479 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_y_n2480 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2481_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_y_n2481 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_y_n2482 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_y_n2483 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2484 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2485 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_y_n2486 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_y_n2487 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2601 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_unit_y_n2602 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_bump_unit_y_n2621 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2666 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2676 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2680_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_z_n2680 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_z_n2681 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_z_n2682 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2683 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2684 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_z_n2685 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_z_n2686 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2687_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_z_n2687 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_z_n2688 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_z_n2689 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2690 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2691 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_z_n2692 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_z_n2693 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2807 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_bump_unit_z_n2808 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_bump_unit_z_n2827 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n278_s12 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_light_length_n282_s12 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_light_length_n284_s12 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal setup_light_length_n293_s12 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n305_s12 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n317_s12 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n327_s12 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_unit_x_n385_s12 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_x_n395_s12 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n396_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n402_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n555_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n557_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n602_s12 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_y_n611_s12 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n617_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n769_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n771_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n816_s12 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_z_n825_s12 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n831_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n983_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n985_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1247_s12 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_half_length_n1251_s12 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_half_length_n1253_s12 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal setup_half_length_n1262_s12 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1274_s12 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_length_n1286_s12 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_unit_x_n1352_s12 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_x_n1361_s12 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1367_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1520_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1522_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1567_s12 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_y_n1576_s12 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1582_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1734_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1736_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1781_s12 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_z_n1790_s12 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1796_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1948_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1950_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2216_s12 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_bump_unit_x_n2277_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2280_s12 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2395_s12 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_bump_unit_x_n2415_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2417_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2419_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2484_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2487_s12 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2602_s12 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_bump_unit_y_n2621_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2623_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2625_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2690_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2693_s12 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2808_s12 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_bump_unit_z_n2827_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2829_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2831_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s12 : std_logic;
    -- stage 12
    signal setup_light_length_n285 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_length_n286 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n287 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_length_n288 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal setup_light_length_n289 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n290 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_length_n294 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_length_n295 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal setup_light_length_n296 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_light_length_n297 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_length_n298 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n299 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_length_n300 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_light_length_n301 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n302 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal setup_light_length_n306 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_length_n307 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_light_length_n308 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_length_n1254 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_length_n1255 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1256 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_length_n1257 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal setup_half_length_n1258 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1259 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_length_n1263 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_length_n1264 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal setup_half_length_n1265 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_half_length_n1266 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_length_n1267 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1268 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_length_n1269 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_half_length_n1270 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1271 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal setup_half_length_n1275 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_length_n1276 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_half_length_n1277 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_x_n2281_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_x_n2281 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_x_n2282 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_x_n2283 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2284 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2285 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_x_n2286 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_x_n2287 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2288_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_x_n2288 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_x_n2289 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_x_n2290 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2291 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2292 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_x_n2293 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_x_n2294 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2396 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_bump_unit_x_n2397 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_bump_unit_y_n2488_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_y_n2488 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_y_n2489 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_y_n2490 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2491 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2492 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_y_n2493 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_y_n2494 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2495_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_y_n2495 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_y_n2496 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_y_n2497 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2498 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2499 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_y_n2500 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_y_n2501 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2603 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_bump_unit_y_n2604 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_bump_unit_z_n2694_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_z_n2694 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_z_n2695 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_z_n2696 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2697 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2698 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_z_n2699 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_z_n2700 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2701_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_z_n2701 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_z_n2702 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_z_n2703 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2704 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2705 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_z_n2706 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_z_n2707 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2809 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_bump_unit_z_n2810 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_light_length_n302_s13 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal setup_light_length_n306_s13 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_length_n308_s13 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_length_n317_s13 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_length_n327_s13 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_unit_x_n385_s13 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_x_n395_s13 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n396_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n402_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n555_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n557_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n602_s13 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_y_n611_s13 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n617_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n769_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n771_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n816_s13 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_z_n825_s13 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n831_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n983_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n985_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1271_s13 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal setup_half_length_n1275_s13 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_length_n1277_s13 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_length_n1286_s13 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_unit_x_n1352_s13 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_x_n1361_s13 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1367_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1520_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1522_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1567_s13 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_y_n1576_s13 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1582_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1734_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1736_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1781_s13 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_z_n1790_s13 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1796_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1948_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1950_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2216_s13 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_bump_unit_x_n2291_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2294_s13 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2397_s13 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_bump_unit_x_n2415_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2417_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2419_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2498_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2501_s13 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2604_s13 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_bump_unit_y_n2621_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2623_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2625_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2704_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2707_s13 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2810_s13 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_bump_unit_z_n2827_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2829_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2831_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s13 : std_logic;
    -- stage 13
    signal setup_light_length_n309 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_length_n310 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n311 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_length_n312 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_length_n313 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n314 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_light_length_n318 : unsigned(25 downto 0) := (others => '0'); -- u26f0
    signal setup_light_length_n319 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_length_n320 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_length_n321 : signed(26 downto 0) := (others => '0'); -- s27f0
    signal setup_light_length_n322 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n323 : signed(26 downto 0) := (others => '0'); -- s27f0
    signal setup_light_length_n324 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_length_n325 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n326 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_length_n328 : unsigned(26 downto 0) := (others => '0'); -- u27f0
    signal setup_light_length_n329 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_length_n330 : unsigned(25 downto 0) := (others => '0'); -- u26f0
    signal setup_half_length_n1278 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_length_n1279 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1280 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_length_n1281 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_length_n1282 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1283 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_half_length_n1287 : unsigned(25 downto 0) := (others => '0'); -- u26f0
    signal setup_half_length_n1288 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_length_n1289 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_length_n1290 : signed(26 downto 0) := (others => '0'); -- s27f0
    signal setup_half_length_n1291 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1292 : signed(26 downto 0) := (others => '0'); -- s27f0
    signal setup_half_length_n1293 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_length_n1294 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1295 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_length_n1296 : unsigned(26 downto 0) := (others => '0'); -- u27f0
    signal setup_half_length_n1297 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_length_n1298 : unsigned(25 downto 0) := (others => '0'); -- u26f0
    signal setup_bump_unit_x_n2295_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_x_n2295 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_x_n2296 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_x_n2297 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2298 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2299 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_x_n2300 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_x_n2301 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2302_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_x_n2302 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_x_n2303 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_x_n2304 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2305 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2306 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_x_n2307 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_x_n2308 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2398 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_bump_unit_x_n2399 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_bump_unit_y_n2502_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_y_n2502 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_y_n2503 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_y_n2504 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2505 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2506 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_y_n2507 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_y_n2508 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2509_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_y_n2509 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_y_n2510 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_y_n2511 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2512 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2513 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_y_n2514 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_y_n2515 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2605 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_bump_unit_y_n2606 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_bump_unit_z_n2708_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_z_n2708 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_z_n2709 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_z_n2710 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2711 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2712 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_z_n2713 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_z_n2714 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2715_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_z_n2715 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_z_n2716 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_z_n2717 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2718 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2719 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_z_n2720 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_z_n2721 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2811 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_bump_unit_z_n2812 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_light_length_n326_s14 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_length_n328_s14 : unsigned(26 downto 0) := (others => '0'); -- u27f0
    signal setup_light_length_n330_s14 : unsigned(25 downto 0) := (others => '0'); -- u26f0
    signal setup_light_unit_x_n385_s14 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_x_n395_s14 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n396_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n402_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n555_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n557_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n602_s14 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_y_n611_s14 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n617_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n769_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n771_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n816_s14 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_z_n825_s14 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n831_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n983_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n985_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1295_s14 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_length_n1296_s14 : unsigned(26 downto 0) := (others => '0'); -- u27f0
    signal setup_half_length_n1298_s14 : unsigned(25 downto 0) := (others => '0'); -- u26f0
    signal setup_half_unit_x_n1352_s14 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_x_n1361_s14 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1367_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1520_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1522_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1567_s14 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_y_n1576_s14 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1582_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1734_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1736_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1781_s14 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_z_n1790_s14 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1796_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1948_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1950_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2216_s14 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_bump_unit_x_n2305_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2308_s14 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2399_s14 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_bump_unit_x_n2415_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2417_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2419_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2512_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2515_s14 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2606_s14 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_bump_unit_y_n2621_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2623_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2625_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2718_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2721_s14 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2812_s14 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_bump_unit_z_n2827_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2829_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2831_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s14 : std_logic;
    -- stage 14
    signal setup_light_length_n331 : signed(27 downto 0) := (others => '0'); -- s28f0
    signal setup_light_length_n332 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n333 : signed(27 downto 0) := (others => '0'); -- s28f0
    signal setup_light_length_n334 : unsigned(25 downto 0) := (others => '0'); -- u26f0
    signal setup_light_length_n335 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n336 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_length_n337 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n338 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_length_n339 : unsigned(25 downto 0) := (others => '0'); -- u26f0
    signal setup_light_length_n340 : unsigned(25 downto 0) := (others => '0'); -- u26f20
    signal setup_half_length_n1299 : signed(27 downto 0) := (others => '0'); -- s28f0
    signal setup_half_length_n1300 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1301 : signed(27 downto 0) := (others => '0'); -- s28f0
    signal setup_half_length_n1302 : unsigned(25 downto 0) := (others => '0'); -- u26f0
    signal setup_half_length_n1303 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1304 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_length_n1305 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1306 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1307 : unsigned(25 downto 0) := (others => '0'); -- u26f0
    signal setup_half_length_n1308 : unsigned(25 downto 0) := (others => '0'); -- u26f20
    signal setup_bump_unit_x_n2309_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_x_n2309 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_x_n2310 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_x_n2311 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2312 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2313 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_x_n2314 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_x_n2315 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2316_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_x_n2316 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_x_n2317 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_x_n2318 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2319 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2320 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_x_n2321 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_x_n2322 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2400 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal setup_bump_unit_x_n2401 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_bump_unit_y_n2516_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_y_n2516 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_y_n2517 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_y_n2518 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2519 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2520 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_y_n2521 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_y_n2522 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2523_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_y_n2523 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_y_n2524 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_y_n2525 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2526 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2527 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_y_n2528 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_y_n2529 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2607 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal setup_bump_unit_y_n2608 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_bump_unit_z_n2722_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_z_n2722 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_z_n2723 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_z_n2724 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2725 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2726 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_z_n2727 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_z_n2728 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2729_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_z_n2729 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_z_n2730 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_z_n2731 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2732 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2733 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_z_n2734 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_z_n2735 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2813 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal setup_bump_unit_z_n2814 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_light_length_n340_s15 : unsigned(25 downto 0) := (others => '0'); -- u26f20
    signal setup_light_unit_x_n385_s15 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_x_n395_s15 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n396_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n402_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n555_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n557_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n602_s15 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_y_n611_s15 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n617_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n769_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n771_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n816_s15 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_light_unit_z_n825_s15 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n831_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n983_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n985_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_n1308_s15 : unsigned(25 downto 0) := (others => '0'); -- u26f20
    signal setup_half_unit_x_n1352_s15 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_x_n1361_s15 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1367_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1520_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1522_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1567_s15 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_y_n1576_s15 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1582_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1734_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1736_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1781_s15 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal setup_half_unit_z_n1790_s15 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1796_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1948_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1950_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2216_s15 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_bump_unit_x_n2319_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2322_s15 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2401_s15 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_bump_unit_x_n2415_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2417_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2419_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2526_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2529_s15 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2608_s15 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_bump_unit_y_n2621_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2623_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2625_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2732_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2735_s15 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2814_s15 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_bump_unit_z_n2827_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2829_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2831_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s15 : std_logic;
    -- stage 15
    signal setup_light_length_length_sum : unsigned(26 downto 0) := (others => '0');
    signal setup_light_length_length_cut : unsigned(24 downto 0) := (others => '0');
    signal setup_light_length_length_over : unsigned(0 downto 0) := (others => '0');
    signal setup_light_length_length : unsigned(22 downto 0) := (others => '0'); -- u23f18
    signal setup_light_unit_x_n344 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_light_unit_x_n386 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n387 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n397_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_x_n397 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_x_n398 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_x_n399 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n400 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n401 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_x_n403 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_x_n404 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n552 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n553 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n603 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n604 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n612_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_y_n612 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_y_n613 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_y_n614 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n615 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n616 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_y_n618 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_y_n619 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n767 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n817 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n818 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n826_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_z_n826 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_z_n827 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_z_n828 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n829 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n830 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_z_n832 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_z_n833 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n981 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_length_length_sum : unsigned(26 downto 0) := (others => '0');
    signal setup_half_length_length_cut : unsigned(24 downto 0) := (others => '0');
    signal setup_half_length_length_over : unsigned(0 downto 0) := (others => '0');
    signal setup_half_length_length : unsigned(22 downto 0) := (others => '0'); -- u23f18
    signal setup_half_unit_x_n1311 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_half_unit_x_n1353 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1354 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1362_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_x_n1362 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_x_n1363 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_x_n1364 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1365 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1366 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_x_n1368 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_x_n1369 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1517 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1518 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1568 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1569 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1577_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_y_n1577 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_y_n1578 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_y_n1579 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1580 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1581 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_y_n1583 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_y_n1584 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1732 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1782 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1783 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1791_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_z_n1791 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_z_n1792 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_z_n1793 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1794 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1795 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_z_n1797 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_z_n1798 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1946 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2323_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_x_n2323 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_x_n2324 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_x_n2325 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2326 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2327 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_x_n2328 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_x_n2329 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2330_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_x_n2330 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_x_n2331 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_x_n2332 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2333 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2334 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_x_n2335 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_x_n2336 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2402 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_bump_unit_x_n2403 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_bump_unit_y_n2530_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_y_n2530 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_y_n2531 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_y_n2532 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2533 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2534 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_y_n2535 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_y_n2536 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2537_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_y_n2537 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_y_n2538 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_y_n2539 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2540 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2541 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_y_n2542 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_y_n2543 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2609 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_bump_unit_y_n2610 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_bump_unit_z_n2736_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_z_n2736 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_z_n2737 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_z_n2738 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2739 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2740 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_z_n2741 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_z_n2742 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2743_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_z_n2743 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_z_n2744 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_z_n2745 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2746 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2747 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_z_n2748 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_z_n2749 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2815 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_bump_unit_z_n2816 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_light_unit_x_n344_s16 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_light_unit_x_n400_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n404_s16 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n553_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n555_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n557_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n615_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n619_s16 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n767_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n769_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n771_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n829_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n833_s16 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n981_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n983_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n985_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1311_s16 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_half_unit_x_n1365_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1369_s16 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1518_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1520_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1522_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1580_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1584_s16 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1732_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1734_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1736_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1794_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1798_s16 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1946_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1948_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1950_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2216_s16 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_bump_unit_x_n2333_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2336_s16 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2403_s16 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_bump_unit_x_n2415_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2417_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2419_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2540_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2543_s16 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2610_s16 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_bump_unit_y_n2621_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2623_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2625_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2746_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2749_s16 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2816_s16 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_bump_unit_z_n2827_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2829_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2831_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s16 : std_logic;
    -- stage 16
    signal setup_light_unit_x_n405_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_x_n405 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_x_n406 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_x_n407 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n408 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n409 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_x_n410 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_x_n411 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n412_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_x_n412 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_x_n413 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_x_n414 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n415 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n416 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_x_n417 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_x_n418 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n532 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_unit_x_n533 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_light_unit_y_n620_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_y_n620 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_y_n621 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_y_n622 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n623 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n624 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_y_n625 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_y_n626 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n627_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_y_n627 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_y_n628 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_y_n629 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n630 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n631 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_y_n632 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_y_n633 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n747 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_unit_y_n748 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_light_unit_z_n834_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_z_n834 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_z_n835 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_z_n836 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n837 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n838 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_z_n839 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_z_n840 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n841_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_z_n841 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_z_n842 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_z_n843 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n844 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n845 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_z_n846 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_z_n847 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n961 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_light_unit_z_n962 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_half_unit_x_n1370_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_x_n1370 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_x_n1371 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_x_n1372 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1373 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1374 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_x_n1375 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_x_n1376 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1377_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_x_n1377 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_x_n1378 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_x_n1379 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1380 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1381 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_x_n1382 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_x_n1383 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1497 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_unit_x_n1498 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_half_unit_y_n1585_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_y_n1585 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_y_n1586 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_y_n1587 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1588 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1589 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_y_n1590 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_y_n1591 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1592_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_y_n1592 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_y_n1593 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_y_n1594 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1595 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1596 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_y_n1597 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_y_n1598 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1712 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_unit_y_n1713 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_half_unit_z_n1799_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_z_n1799 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_z_n1800 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_z_n1801 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1802 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1803 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_z_n1804 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_z_n1805 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1806_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_z_n1806 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_z_n1807 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_z_n1808 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1809 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1810 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_z_n1811 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_z_n1812 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1926 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal setup_half_unit_z_n1927 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_bump_unit_x_n2337_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_x_n2337 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_x_n2338 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_x_n2339 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2340 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2341 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_x_n2342 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_x_n2343 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2344_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_x_n2344 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_x_n2345 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_x_n2346 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2347 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2348 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_x_n2349 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_x_n2350 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2404 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_bump_unit_x_n2405 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_bump_unit_y_n2544_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_y_n2544 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_y_n2545 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_y_n2546 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2547 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2548 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_y_n2549 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_y_n2550 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2551_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_y_n2551 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_y_n2552 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_y_n2553 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2554 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2555 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_y_n2556 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_y_n2557 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2611 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_bump_unit_y_n2612 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_bump_unit_z_n2750_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_z_n2750 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_z_n2751 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_z_n2752 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2753 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2754 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_z_n2755 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_z_n2756 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2757_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_z_n2757 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_z_n2758 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_z_n2759 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2760 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2761 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_z_n2762 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_z_n2763 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2817 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_bump_unit_z_n2818 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_light_unit_x_n344_s17 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_light_unit_x_n415_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n418_s17 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n533_s17 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_light_unit_x_n553_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n555_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n557_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n630_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n633_s17 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n748_s17 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_light_unit_y_n767_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n769_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n771_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n844_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n847_s17 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n962_s17 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_light_unit_z_n981_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n983_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n985_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1311_s17 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_half_unit_x_n1380_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1383_s17 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1498_s17 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_half_unit_x_n1518_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1520_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1522_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1595_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1598_s17 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1713_s17 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_half_unit_y_n1732_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1734_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1736_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1809_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1812_s17 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1927_s17 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal setup_half_unit_z_n1946_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1948_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1950_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2216_s17 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_bump_unit_x_n2347_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2350_s17 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2405_s17 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_bump_unit_x_n2415_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2417_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2419_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2554_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2557_s17 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2612_s17 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_bump_unit_y_n2621_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2623_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2625_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2760_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2763_s17 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2818_s17 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_bump_unit_z_n2827_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2829_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2831_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s17 : std_logic;
    -- stage 17
    signal setup_light_unit_x_n419_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_x_n419 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_x_n420 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_x_n421 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n422 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n423 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_x_n424 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_x_n425 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n426_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_x_n426 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_x_n427 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_x_n428 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n429 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n430 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_x_n431 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_x_n432 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n534 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_light_unit_x_n535 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_light_unit_y_n634_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_y_n634 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_y_n635 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_y_n636 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n637 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n638 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_y_n639 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_y_n640 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n641_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_y_n641 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_y_n642 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_y_n643 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n644 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n645 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_y_n646 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_y_n647 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n749 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_light_unit_y_n750 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_light_unit_z_n848_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_z_n848 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_z_n849 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_z_n850 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n851 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n852 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_z_n853 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_z_n854 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n855_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_z_n855 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_z_n856 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_z_n857 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n858 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n859 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_z_n860 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_z_n861 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n963 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_light_unit_z_n964 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_half_unit_x_n1384_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_x_n1384 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_x_n1385 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_x_n1386 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1387 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1388 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_x_n1389 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_x_n1390 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1391_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_x_n1391 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_x_n1392 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_x_n1393 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1394 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1395 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_x_n1396 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_x_n1397 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1499 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_half_unit_x_n1500 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_half_unit_y_n1599_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_y_n1599 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_y_n1600 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_y_n1601 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1602 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1603 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_y_n1604 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_y_n1605 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1606_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_y_n1606 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_y_n1607 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_y_n1608 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1609 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1610 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_y_n1611 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_y_n1612 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1714 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_half_unit_y_n1715 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_half_unit_z_n1813_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_z_n1813 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_z_n1814 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_z_n1815 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1816 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1817 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_z_n1818 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_z_n1819 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1820_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_z_n1820 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_z_n1821 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_z_n1822 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1823 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1824 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_z_n1825 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_z_n1826 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1928 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_half_unit_z_n1929 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_bump_unit_x_n2351_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_x_n2351 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_x_n2352 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_x_n2353 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2354 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2355 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_x_n2356 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_x_n2357 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2358_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_x_n2358 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_x_n2359 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_x_n2360 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2361 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2362 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_x_n2363 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_x_n2364 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2406 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal setup_bump_unit_x_n2407 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_bump_unit_y_n2558_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_y_n2558 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_y_n2559 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_y_n2560 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2561 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2562 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_y_n2563 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_y_n2564 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2565_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_y_n2565 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_y_n2566 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_y_n2567 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2568 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2569 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_y_n2570 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_y_n2571 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2613 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal setup_bump_unit_y_n2614 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_bump_unit_z_n2764_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_z_n2764 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_z_n2765 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_z_n2766 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2767 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2768 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_z_n2769 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_z_n2770 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2771_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_z_n2771 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_z_n2772 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_z_n2773 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2774 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2775 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_z_n2776 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_z_n2777 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2819 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal setup_bump_unit_z_n2820 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_light_unit_x_n344_s18 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_light_unit_x_n429_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n432_s18 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n535_s18 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_light_unit_x_n553_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n555_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n557_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n644_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n647_s18 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n750_s18 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_light_unit_y_n767_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n769_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n771_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n858_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n861_s18 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n964_s18 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_light_unit_z_n981_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n983_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n985_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1311_s18 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_half_unit_x_n1394_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1397_s18 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1500_s18 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_half_unit_x_n1518_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1520_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1522_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1609_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1612_s18 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1715_s18 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_half_unit_y_n1732_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1734_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1736_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1823_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1826_s18 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1929_s18 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_half_unit_z_n1946_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1948_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1950_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2216_s18 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_bump_unit_x_n2361_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2364_s18 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2407_s18 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_bump_unit_x_n2415_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2417_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2419_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2568_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2571_s18 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2614_s18 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_bump_unit_y_n2621_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2623_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2625_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2774_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2777_s18 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2820_s18 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_bump_unit_z_n2827_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2829_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2831_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s18 : std_logic;
    -- stage 18
    signal setup_light_unit_x_n433_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_x_n433 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_x_n434 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_x_n435 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n436 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n437 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_x_n438 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_x_n439 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n440_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_x_n440 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_x_n441 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_x_n442 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n443 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n444 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_x_n445 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_x_n446 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n536 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_light_unit_x_n537 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_light_unit_y_n648_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_y_n648 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_y_n649 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_y_n650 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n651 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n652 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_y_n653 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_y_n654 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n655_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_y_n655 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_y_n656 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_y_n657 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n658 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n659 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_y_n660 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_y_n661 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n751 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_light_unit_y_n752 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_light_unit_z_n862_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_z_n862 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_z_n863 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_z_n864 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n865 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n866 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_z_n867 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_z_n868 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n869_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_z_n869 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_z_n870 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_z_n871 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n872 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n873 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_z_n874 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_z_n875 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n965 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_light_unit_z_n966 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_half_unit_x_n1398_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_x_n1398 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_x_n1399 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_x_n1400 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1401 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1402 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_x_n1403 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_x_n1404 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1405_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_x_n1405 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_x_n1406 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_x_n1407 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1408 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1409 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_x_n1410 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_x_n1411 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1501 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_half_unit_x_n1502 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_half_unit_y_n1613_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_y_n1613 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_y_n1614 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_y_n1615 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1616 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1617 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_y_n1618 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_y_n1619 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1620_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_y_n1620 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_y_n1621 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_y_n1622 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1623 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1624 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_y_n1625 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_y_n1626 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1716 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_half_unit_y_n1717 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_half_unit_z_n1827_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_z_n1827 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_z_n1828 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_z_n1829 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1830 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1831 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_z_n1832 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_z_n1833 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1834_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_z_n1834 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_z_n1835 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_z_n1836 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1837 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1838 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_z_n1839 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_z_n1840 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1930 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal setup_half_unit_z_n1931 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_bump_unit_x_n2365_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_x_n2365 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_x_n2366 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_x_n2367 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2368 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2369 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_x_n2370 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_x_n2371 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2372_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_x_n2372 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_x_n2373 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_x_n2374 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2375 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2376 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_x_n2377 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_x_n2378 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2408 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_bump_unit_x_n2409 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_bump_unit_y_n2572_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_y_n2572 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_y_n2573 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_y_n2574 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2575 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2576 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_y_n2577 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_y_n2578 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2579_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_y_n2579 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_y_n2580 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_y_n2581 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2582 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2583 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_y_n2584 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_y_n2585 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2615 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_bump_unit_y_n2616 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_bump_unit_z_n2778_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_z_n2778 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_z_n2779 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_z_n2780 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2781 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2782 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_z_n2783 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_z_n2784 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2785_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_z_n2785 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_z_n2786 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_z_n2787 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2788 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2789 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_z_n2790 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_z_n2791 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2821 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_bump_unit_z_n2822 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_light_unit_x_n344_s19 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_light_unit_x_n443_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n446_s19 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n537_s19 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_light_unit_x_n553_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n555_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n557_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n658_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n661_s19 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n752_s19 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_light_unit_y_n767_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n769_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n771_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n872_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n875_s19 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n966_s19 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_light_unit_z_n981_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n983_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n985_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1311_s19 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_half_unit_x_n1408_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1411_s19 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1502_s19 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_half_unit_x_n1518_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1520_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1522_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1623_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1626_s19 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1717_s19 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_half_unit_y_n1732_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1734_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1736_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1837_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1840_s19 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1931_s19 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal setup_half_unit_z_n1946_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1948_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1950_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2216_s19 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_bump_unit_x_n2375_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2378_s19 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2409_s19 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_bump_unit_x_n2415_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2417_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2419_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2582_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2585_s19 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2616_s19 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_bump_unit_y_n2621_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2623_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2625_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2788_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2791_s19 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2822_s19 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_bump_unit_z_n2827_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2829_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2831_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s19 : std_logic;
    -- stage 19
    signal setup_light_unit_x_n447_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_x_n447 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_x_n448 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_x_n449 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n450 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n451 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_x_n452 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_x_n453 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n454_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_x_n454 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_x_n455 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_x_n456 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n457 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n458 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_x_n459 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_x_n460 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n538 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal setup_light_unit_x_n539 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_light_unit_y_n662_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_y_n662 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_y_n663 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_y_n664 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n665 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n666 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_y_n667 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_y_n668 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n669_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_y_n669 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_y_n670 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_y_n671 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n672 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n673 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_y_n674 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_y_n675 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n753 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal setup_light_unit_y_n754 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_light_unit_z_n876_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_z_n876 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_z_n877 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_z_n878 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n879 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n880 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_z_n881 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_z_n882 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n883_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_z_n883 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_z_n884 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_z_n885 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n886 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n887 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_z_n888 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_z_n889 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n967 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal setup_light_unit_z_n968 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_half_unit_x_n1412_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_x_n1412 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_x_n1413 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_x_n1414 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1415 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1416 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_x_n1417 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_x_n1418 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1419_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_x_n1419 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_x_n1420 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_x_n1421 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1422 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1423 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_x_n1424 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_x_n1425 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1503 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal setup_half_unit_x_n1504 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_half_unit_y_n1627_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_y_n1627 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_y_n1628 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_y_n1629 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1630 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1631 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_y_n1632 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_y_n1633 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1634_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_y_n1634 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_y_n1635 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_y_n1636 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1637 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1638 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_y_n1639 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_y_n1640 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1718 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal setup_half_unit_y_n1719 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_half_unit_z_n1841_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_z_n1841 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_z_n1842 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_z_n1843 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1844 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1845 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_z_n1846 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_z_n1847 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1848_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_z_n1848 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_z_n1849 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_z_n1850 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1851 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1852 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_z_n1853 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_z_n1854 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1932 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal setup_half_unit_z_n1933 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_bump_unit_x_n2379_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_x_n2379 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_x_n2380 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_x_n2381 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2382 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2383 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_x_n2384 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_x_n2385 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2386_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_x_n2386 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_x_n2387 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_x_n2388 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2389 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2390 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2410 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_x_n2411 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_bump_unit_y_n2586_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_y_n2586 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_y_n2587 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_y_n2588 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2589 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2590 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_y_n2591 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_y_n2592 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2593_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_y_n2593 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_y_n2594 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_y_n2595 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2596 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2597 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2617 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_y_n2618 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_bump_unit_z_n2792_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_z_n2792 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_z_n2793 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_z_n2794 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2795 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2796 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_bump_unit_z_n2797 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_bump_unit_z_n2798 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2799_term : unsigned(25 downto 0) := (others => '0');
    signal setup_bump_unit_z_n2799 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_bump_unit_z_n2800 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_z_n2801 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2802 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2803 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2823 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_bump_unit_z_n2824 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_light_unit_x_n344_s20 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_light_unit_x_n457_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n460_s20 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n539_s20 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_light_unit_x_n553_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n555_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n557_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n672_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n675_s20 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n754_s20 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_light_unit_y_n767_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n769_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n771_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n886_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n889_s20 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n968_s20 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_light_unit_z_n981_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n983_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n985_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1311_s20 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_half_unit_x_n1422_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1425_s20 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1504_s20 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_half_unit_x_n1518_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1520_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1522_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1637_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1640_s20 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1719_s20 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_half_unit_y_n1732_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1734_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1736_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1851_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1854_s20 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1933_s20 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal setup_half_unit_z_n1946_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1948_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1950_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2387_s20 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_x_n2388_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2390_s20 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2411_s20 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_bump_unit_x_n2415_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2417_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2419_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2594_s20 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_y_n2595_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2597_s20 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2618_s20 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_bump_unit_y_n2621_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2623_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2625_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2800_s20 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_bump_unit_z_n2801_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2803_s20 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2824_s20 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_bump_unit_z_n2827_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2829_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2831_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s20 : std_logic;
    -- stage 20
    signal setup_light_unit_x_n461_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_x_n461 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_x_n462 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_x_n463 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n464 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n465 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_x_n466 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_x_n467 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n468_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_x_n468 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_x_n469 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_x_n470 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n471 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n472 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_x_n473 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_x_n474 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n540 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_light_unit_x_n541 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_light_unit_y_n676_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_y_n676 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_y_n677 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_y_n678 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n679 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n680 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_y_n681 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_y_n682 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n683_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_y_n683 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_y_n684 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_y_n685 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n686 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n687 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_y_n688 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_y_n689 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n755 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_light_unit_y_n756 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_light_unit_z_n890_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_z_n890 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_z_n891 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_z_n892 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n893 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n894 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_z_n895 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_z_n896 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n897_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_z_n897 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_z_n898 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_z_n899 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n900 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n901 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_z_n902 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_z_n903 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n969 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_light_unit_z_n970 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_half_unit_x_n1426_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_x_n1426 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_x_n1427 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_x_n1428 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1429 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1430 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_x_n1431 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_x_n1432 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1433_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_x_n1433 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_x_n1434 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_x_n1435 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1436 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1437 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_x_n1438 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_x_n1439 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1505 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_half_unit_x_n1506 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_half_unit_y_n1641_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_y_n1641 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_y_n1642 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_y_n1643 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1644 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1645 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_y_n1646 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_y_n1647 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1648_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_y_n1648 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_y_n1649 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_y_n1650 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1651 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1652 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_y_n1653 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_y_n1654 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1720 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_half_unit_y_n1721 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_half_unit_z_n1855_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_z_n1855 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_z_n1856 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_z_n1857 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1858 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1859 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_z_n1860 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_z_n1861 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1862_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_z_n1862 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_z_n1863 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_z_n1864 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1865 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1866 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_z_n1867 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_z_n1868 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1934 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_half_unit_z_n1935 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_bump_unit_x_n2391 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_x_n2392 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2393 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2412 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_bump_unit_x_n2413 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_bump_unit_x_n2416 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_bump_unit_x_n2418 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_bump_unit_x_n2420 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_bump_unit_y_n2598 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_y_n2599 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2600 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2619 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_bump_unit_y_n2620 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_bump_unit_y_n2622 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_bump_unit_y_n2624 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_bump_unit_y_n2626 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_bump_unit_z_n2804 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_bump_unit_z_n2805 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2806 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2825 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_bump_unit_z_n2826 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_bump_unit_z_n2828 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_bump_unit_z_n2830 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_bump_unit_z_n2832 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_light_unit_x_n344_s21 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_light_unit_x_n471_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n474_s21 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n541_s21 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_light_unit_x_n553_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n555_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n557_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n686_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n689_s21 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n756_s21 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_light_unit_y_n767_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n769_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n771_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n900_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n903_s21 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n970_s21 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_light_unit_z_n981_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n983_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n985_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1311_s21 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_half_unit_x_n1436_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1439_s21 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1506_s21 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_half_unit_x_n1518_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1520_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1522_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1651_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1654_s21 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1721_s21 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_half_unit_y_n1732_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1734_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1736_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1865_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1868_s21 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1935_s21 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal setup_half_unit_z_n1946_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1948_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1950_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2418_s21 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_bump_unit_x_n2419_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_n2420_s21 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_bump_unit_y_n2624_s21 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_bump_unit_y_n2625_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_y_n2626_s21 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_bump_unit_z_n2830_s21 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_bump_unit_z_n2831_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_z_n2832_s21 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal valid_s21 : std_logic;
    -- stage 21
    signal setup_light_unit_x_n475_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_x_n475 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_x_n476 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_x_n477 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n478 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n479 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_x_n480 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_x_n481 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n482_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_x_n482 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_x_n483 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_x_n484 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n485 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n486 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_x_n487 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_x_n488 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n542 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_light_unit_x_n543 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_light_unit_y_n690_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_y_n690 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_y_n691 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_y_n692 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n693 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n694 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_y_n695 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_y_n696 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n697_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_y_n697 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_y_n698 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_y_n699 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n700 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n701 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_y_n702 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_y_n703 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n757 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_light_unit_y_n758 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_light_unit_z_n904_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_z_n904 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_z_n905 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_z_n906 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n907 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n908 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_z_n909 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_z_n910 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n911_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_z_n911 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_z_n912 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_z_n913 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n914 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n915 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_z_n916 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_z_n917 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n971 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_light_unit_z_n972 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_half_unit_x_n1440_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_x_n1440 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_x_n1441 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_x_n1442 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1443 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1444 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_x_n1445 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_x_n1446 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1447_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_x_n1447 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_x_n1448 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_x_n1449 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1450 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1451 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_x_n1452 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_x_n1453 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1507 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_half_unit_x_n1508 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_half_unit_y_n1655_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_y_n1655 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_y_n1656 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_y_n1657 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1658 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1659 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_y_n1660 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_y_n1661 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1662_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_y_n1662 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_y_n1663 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_y_n1664 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1665 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1666 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_y_n1667 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_y_n1668 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1722 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_half_unit_y_n1723 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_half_unit_z_n1869_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_z_n1869 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_z_n1870 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_z_n1871 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1872 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1873 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_z_n1874 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_z_n1875 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1876_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_z_n1876 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_z_n1877 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_z_n1878 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1879 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1880 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_z_n1881 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_z_n1882 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1936 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal setup_half_unit_z_n1937 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_bump_unit_x_n2421 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_bump_unit_x_x_sum : signed(21 downto 0) := (others => '0');
    signal setup_bump_unit_x_x_cut : signed(19 downto 0) := (others => '0');
    signal setup_bump_unit_x_x_over : unsigned(0 downto 0) := (others => '0');
    signal setup_bump_unit_x_x_under : unsigned(0 downto 0) := (others => '0');
    signal setup_bump_unit_x_x : signed(17 downto 0) := (others => '0'); -- s18f16
    signal setup_bump_unit_y_n2627 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_bump_unit_y_y_sum : signed(21 downto 0) := (others => '0');
    signal setup_bump_unit_y_y_cut : signed(19 downto 0) := (others => '0');
    signal setup_bump_unit_y_y_over : unsigned(0 downto 0) := (others => '0');
    signal setup_bump_unit_y_y_under : unsigned(0 downto 0) := (others => '0');
    signal setup_bump_unit_y_y : signed(17 downto 0) := (others => '0'); -- s18f16
    signal setup_bump_unit_z_n2833 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_bump_unit_z_z_sum : signed(21 downto 0) := (others => '0');
    signal setup_bump_unit_z_z_cut : signed(19 downto 0) := (others => '0');
    signal setup_bump_unit_z_z_over : unsigned(0 downto 0) := (others => '0');
    signal setup_bump_unit_z_z_under : unsigned(0 downto 0) := (others => '0');
    signal setup_bump_unit_z_z : signed(17 downto 0) := (others => '0'); -- s18f16
    signal setup_light_unit_x_n344_s22 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_light_unit_x_n485_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n488_s22 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n543_s22 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_light_unit_x_n553_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n555_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n557_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n700_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n703_s22 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n758_s22 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_light_unit_y_n767_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n769_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n771_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n914_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n917_s22 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n972_s22 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_light_unit_z_n981_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n983_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n985_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1311_s22 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_half_unit_x_n1450_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1453_s22 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1508_s22 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_half_unit_x_n1518_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1520_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1522_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1665_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1668_s22 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1723_s22 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_half_unit_y_n1732_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1734_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1736_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1879_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1882_s22 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1937_s22 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal setup_half_unit_z_n1946_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1948_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1950_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_x_s22 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal setup_bump_unit_y_y_s22 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal setup_bump_unit_z_z_s22 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal valid_s22 : std_logic;
    -- stage 22
    signal setup_light_unit_x_n489_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_x_n489 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_x_n490 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_x_n491 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n492 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n493 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_x_n494 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_x_n495 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n496_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_x_n496 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_x_n497 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_x_n498 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n499 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n500 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_x_n501 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_x_n502 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n544 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal setup_light_unit_x_n545 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_light_unit_y_n704_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_y_n704 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_y_n705 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_y_n706 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n707 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n708 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_y_n709 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_y_n710 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n711_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_y_n711 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_y_n712 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_y_n713 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n714 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n715 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_y_n716 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_y_n717 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n759 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal setup_light_unit_y_n760 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_light_unit_z_n918_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_z_n918 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_z_n919 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_z_n920 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n921 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n922 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_z_n923 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_z_n924 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n925_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_z_n925 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_z_n926 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_z_n927 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n928 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n929 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_z_n930 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_z_n931 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n973 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal setup_light_unit_z_n974 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_half_unit_x_n1454_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_x_n1454 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_x_n1455 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_x_n1456 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1457 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1458 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_x_n1459 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_x_n1460 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1461_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_x_n1461 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_x_n1462 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_x_n1463 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1464 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1465 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_x_n1466 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_x_n1467 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1509 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal setup_half_unit_x_n1510 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_half_unit_y_n1669_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_y_n1669 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_y_n1670 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_y_n1671 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1672 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1673 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_y_n1674 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_y_n1675 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1676_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_y_n1676 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_y_n1677 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_y_n1678 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1679 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1680 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_y_n1681 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_y_n1682 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1724 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal setup_half_unit_y_n1725 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_half_unit_z_n1883_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_z_n1883 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_z_n1884 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_z_n1885 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1886 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1887 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_z_n1888 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_z_n1889 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1890_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_z_n1890 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_z_n1891 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_z_n1892 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1893 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1894 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_z_n1895 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_z_n1896 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1938 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal setup_half_unit_z_n1939 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_light_unit_x_n344_s23 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_light_unit_x_n499_s23 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n502_s23 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n545_s23 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_light_unit_x_n553_s23 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n555_s23 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n557_s23 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n714_s23 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n717_s23 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n760_s23 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_light_unit_y_n767_s23 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n769_s23 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n771_s23 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n928_s23 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n931_s23 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n974_s23 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_light_unit_z_n981_s23 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n983_s23 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n985_s23 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1311_s23 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_half_unit_x_n1464_s23 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1467_s23 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1510_s23 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_half_unit_x_n1518_s23 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1520_s23 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1522_s23 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1679_s23 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1682_s23 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1725_s23 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_half_unit_y_n1732_s23 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1734_s23 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1736_s23 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1893_s23 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1896_s23 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1939_s23 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal setup_half_unit_z_n1946_s23 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1948_s23 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1950_s23 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_x_s23 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal setup_bump_unit_y_y_s23 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal setup_bump_unit_z_z_s23 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal valid_s23 : std_logic;
    -- stage 23
    signal setup_light_unit_x_n503_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_x_n503 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_x_n504 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_x_n505 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n506 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n507 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_x_n508 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_x_n509 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n510_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_x_n510 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_x_n511 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_x_n512 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n513 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n514 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_x_n515 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_x_n516 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n546 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_light_unit_x_n547 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_light_unit_y_n718_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_y_n718 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_y_n719 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_y_n720 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n721 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n722 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_y_n723 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_y_n724 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n725_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_y_n725 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_y_n726 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_y_n727 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n728 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n729 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_y_n730 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_y_n731 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n761 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_light_unit_y_n762 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_light_unit_z_n932_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_z_n932 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_z_n933 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_z_n934 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n935 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n936 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_z_n937 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_z_n938 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n939_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_z_n939 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_z_n940 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_z_n941 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n942 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n943 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_z_n944 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_z_n945 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n975 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_light_unit_z_n976 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_half_unit_x_n1468_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_x_n1468 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_x_n1469 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_x_n1470 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1471 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1472 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_x_n1473 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_x_n1474 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1475_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_x_n1475 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_x_n1476 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_x_n1477 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1478 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1479 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_x_n1480 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_x_n1481 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1511 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_half_unit_x_n1512 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_half_unit_y_n1683_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_y_n1683 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_y_n1684 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_y_n1685 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1686 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1687 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_y_n1688 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_y_n1689 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1690_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_y_n1690 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_y_n1691 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_y_n1692 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1693 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1694 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_y_n1695 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_y_n1696 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1726 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_half_unit_y_n1727 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_half_unit_z_n1897_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_z_n1897 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_z_n1898 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_z_n1899 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1900 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1901 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_z_n1902 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_z_n1903 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1904_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_z_n1904 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_z_n1905 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_z_n1906 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1907 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1908 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_z_n1909 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_z_n1910 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1940 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal setup_half_unit_z_n1941 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_light_unit_x_n344_s24 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_light_unit_x_n513_s24 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n516_s24 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n547_s24 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_light_unit_x_n553_s24 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n555_s24 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n557_s24 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n728_s24 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n731_s24 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n762_s24 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_light_unit_y_n767_s24 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n769_s24 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n771_s24 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n942_s24 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n945_s24 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n976_s24 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_light_unit_z_n981_s24 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n983_s24 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n985_s24 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1311_s24 : unsigned(22 downto 0) := (others => '0'); -- u23f0
    signal setup_half_unit_x_n1478_s24 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1481_s24 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1512_s24 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_half_unit_x_n1518_s24 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1520_s24 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1522_s24 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1693_s24 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1696_s24 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1727_s24 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_half_unit_y_n1732_s24 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1734_s24 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1736_s24 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1907_s24 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1910_s24 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1941_s24 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal setup_half_unit_z_n1946_s24 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1948_s24 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1950_s24 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_x_s24 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal setup_bump_unit_y_y_s24 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal setup_bump_unit_z_z_s24 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal valid_s24 : std_logic;
    -- stage 24
    signal setup_light_unit_x_n517_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_x_n517 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_x_n518 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_x_n519 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n520 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n521 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_x_n522 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_x_n523 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n524_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_x_n524 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_x_n525 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_x_n526 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n527 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n528 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n548 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_light_unit_x_n549 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_light_unit_y_n732_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_y_n732 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_y_n733 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_y_n734 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n735 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n736 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_y_n737 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_y_n738 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n739_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_y_n739 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_y_n740 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_y_n741 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n742 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n743 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n763 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_light_unit_y_n764 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_light_unit_z_n946_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_z_n946 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_z_n947 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_z_n948 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n949 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n950 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_light_unit_z_n951 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_light_unit_z_n952 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n953_term : unsigned(25 downto 0) := (others => '0');
    signal setup_light_unit_z_n953 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_light_unit_z_n954 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_z_n955 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n956 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n957 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n977 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_light_unit_z_n978 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_half_unit_x_n1482_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_x_n1482 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_x_n1483 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_x_n1484 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1485 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1486 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_x_n1487 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_x_n1488 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1489_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_x_n1489 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_x_n1490 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_x_n1491 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1492 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1493 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1513 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_half_unit_x_n1514 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_half_unit_y_n1697_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_y_n1697 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_y_n1698 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_y_n1699 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1700 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1701 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_y_n1702 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_y_n1703 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1704_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_y_n1704 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_y_n1705 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_y_n1706 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1707 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1708 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1728 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_half_unit_y_n1729 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_half_unit_z_n1911_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_z_n1911 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_z_n1912 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_z_n1913 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1914 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1915 : unsigned(23 downto 0) := (others => '0'); -- u24f0
    signal setup_half_unit_z_n1916 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal setup_half_unit_z_n1917 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1918_term : unsigned(25 downto 0) := (others => '0');
    signal setup_half_unit_z_n1918 : signed(25 downto 0) := (others => '0'); -- s26f0
    signal setup_half_unit_z_n1919 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_z_n1920 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1921 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1922 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1942 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal setup_half_unit_z_n1943 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_light_unit_x_n525_s25 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_x_n526_s25 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n528_s25 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n549_s25 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_light_unit_x_n553_s25 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n555_s25 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n557_s25 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n740_s25 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_y_n741_s25 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n743_s25 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n764_s25 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_light_unit_y_n767_s25 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n769_s25 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n771_s25 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n954_s25 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_light_unit_z_n955_s25 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n957_s25 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n978_s25 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_light_unit_z_n981_s25 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n983_s25 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n985_s25 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1490_s25 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_x_n1491_s25 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1493_s25 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1514_s25 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_half_unit_x_n1518_s25 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1520_s25 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1522_s25 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1705_s25 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_y_n1706_s25 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1708_s25 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1729_s25 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_half_unit_y_n1732_s25 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1734_s25 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1736_s25 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1919_s25 : signed(23 downto 0) := (others => '0'); -- s24f0
    signal setup_half_unit_z_n1920_s25 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1922_s25 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1943_s25 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_half_unit_z_n1946_s25 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1948_s25 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1950_s25 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_bump_unit_x_x_s25 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal setup_bump_unit_y_y_s25 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal setup_bump_unit_z_z_s25 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal valid_s25 : std_logic;
    -- stage 25
    signal setup_light_unit_x_n529 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_x_n530 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n531 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n550 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_light_unit_x_n551 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_unit_x_n554 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_unit_x_n556 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_unit_x_n558 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_light_unit_y_n744 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_y_n745 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n746 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n765 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_light_unit_y_n766 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_unit_y_n768 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_unit_y_n770 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_unit_y_n772 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_light_unit_z_n958 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_light_unit_z_n959 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n960 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n979 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_light_unit_z_n980 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_unit_z_n982 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_unit_z_n984 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_unit_z_n986 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_half_unit_x_n1494 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_x_n1495 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1496 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1515 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_half_unit_x_n1516 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_unit_x_n1519 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_unit_x_n1521 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_unit_x_n1523 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_half_unit_y_n1709 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_y_n1710 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1711 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1730 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_half_unit_y_n1731 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_unit_y_n1733 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_unit_y_n1735 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_unit_y_n1737 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_half_unit_z_n1923 : signed(24 downto 0) := (others => '0'); -- s25f0
    signal setup_half_unit_z_n1924 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1925 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1944 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_half_unit_z_n1945 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_unit_z_n1947 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_unit_z_n1949 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_unit_z_n1951 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_light_unit_x_n556_s26 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_unit_x_n557_s26 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_x_n558_s26 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_light_unit_y_n770_s26 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_unit_y_n771_s26 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_y_n772_s26 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_light_unit_z_n984_s26 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_light_unit_z_n985_s26 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_light_unit_z_n986_s26 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_half_unit_x_n1521_s26 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_unit_x_n1522_s26 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_x_n1523_s26 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_half_unit_y_n1735_s26 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_unit_y_n1736_s26 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_y_n1737_s26 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_half_unit_z_n1949_s26 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_half_unit_z_n1950_s26 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_half_unit_z_n1951_s26 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_bump_unit_x_x_s26 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal setup_bump_unit_y_y_s26 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal setup_bump_unit_z_z_s26 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal valid_s26 : std_logic;
    -- stage 26
    signal setup_light_unit_x_n559 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_light_unit_x_x_sum : signed(21 downto 0) := (others => '0');
    signal setup_light_unit_x_x_cut : signed(19 downto 0) := (others => '0');
    signal setup_light_unit_x_x_over : unsigned(0 downto 0) := (others => '0');
    signal setup_light_unit_x_x_under : unsigned(0 downto 0) := (others => '0');
    signal setup_light_unit_x_x : signed(17 downto 0) := (others => '0'); -- s18f16
    signal setup_light_unit_y_n773 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_light_unit_y_y_sum : signed(21 downto 0) := (others => '0');
    signal setup_light_unit_y_y_cut : signed(19 downto 0) := (others => '0');
    signal setup_light_unit_y_y_over : unsigned(0 downto 0) := (others => '0');
    signal setup_light_unit_y_y_under : unsigned(0 downto 0) := (others => '0');
    signal setup_light_unit_y_y : signed(17 downto 0) := (others => '0'); -- s18f16
    signal setup_light_unit_z_n987 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_light_unit_z_z_sum : signed(21 downto 0) := (others => '0');
    signal setup_light_unit_z_z_cut : signed(19 downto 0) := (others => '0');
    signal setup_light_unit_z_z_over : unsigned(0 downto 0) := (others => '0');
    signal setup_light_unit_z_z_under : unsigned(0 downto 0) := (others => '0');
    signal setup_light_unit_z_z : signed(17 downto 0) := (others => '0'); -- s18f16
    signal setup_half_unit_x_n1524 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_half_unit_x_x_sum : signed(21 downto 0) := (others => '0');
    signal setup_half_unit_x_x_cut : signed(19 downto 0) := (others => '0');
    signal setup_half_unit_x_x_over : unsigned(0 downto 0) := (others => '0');
    signal setup_half_unit_x_x_under : unsigned(0 downto 0) := (others => '0');
    signal setup_half_unit_x_x : signed(17 downto 0) := (others => '0'); -- s18f16
    signal setup_half_unit_y_n1738 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_half_unit_y_y_sum : signed(21 downto 0) := (others => '0');
    signal setup_half_unit_y_y_cut : signed(19 downto 0) := (others => '0');
    signal setup_half_unit_y_y_over : unsigned(0 downto 0) := (others => '0');
    signal setup_half_unit_y_y_under : unsigned(0 downto 0) := (others => '0');
    signal setup_half_unit_y_y : signed(17 downto 0) := (others => '0'); -- s18f16
    signal setup_half_unit_z_n1952 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_half_unit_z_z_sum : signed(21 downto 0) := (others => '0');
    signal setup_half_unit_z_z_cut : signed(19 downto 0) := (others => '0');
    signal setup_half_unit_z_z_over : unsigned(0 downto 0) := (others => '0');
    signal setup_half_unit_z_z_under : unsigned(0 downto 0) := (others => '0');
    signal setup_half_unit_z_z : signed(17 downto 0) := (others => '0'); -- s18f16
    signal setup_light_unit_x_x_s27 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal setup_light_unit_y_y_s27 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal setup_light_unit_z_z_s27 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal setup_half_unit_x_x_s27 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal setup_half_unit_y_y_s27 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal setup_half_unit_z_z_s27 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal setup_bump_unit_x_x_s27 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal setup_bump_unit_y_y_s27 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal setup_bump_unit_z_z_s27 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal valid_s27 : std_logic;
    -- stage 27
    signal dot_l_n2835 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal dot_l_n2836 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal dot_l_n2837 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal dot_h_n2841 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal dot_h_n2842 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal dot_h_n2843 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal dot_l_n2835_s28 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal dot_l_n2836_s28 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal dot_l_n2837_s28 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal dot_h_n2841_s28 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal dot_h_n2842_s28 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal dot_h_n2843_s28 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal valid_s28 : std_logic;
    -- stage 28
    signal dot_l_n2838 : signed(36 downto 0) := (others => '0'); -- s37f32
    signal dot_l_n2839 : signed(37 downto 0) := (others => '0'); -- s38f32
    signal dot_h_n2844 : signed(36 downto 0) := (others => '0'); -- s37f32
    signal dot_h_n2845 : signed(37 downto 0) := (others => '0'); -- s38f32
    signal dot_l_n2839_s29 : signed(37 downto 0) := (others => '0'); -- s38f32
    signal dot_h_n2845_s29 : signed(37 downto 0) := (others => '0'); -- s38f32
    signal valid_s29 : std_logic;
    -- stage 29
    signal dot_l_sum : signed(38 downto 0) := (others => '0');
    signal dot_l_cut : signed(22 downto 0) := (others => '0');
    signal dot_l_over : unsigned(0 downto 0) := (others => '0');
    signal dot_l_under : unsigned(0 downto 0) := (others => '0');
    signal dot_l : signed(20 downto 0) := (others => '0'); -- s21f16
    signal dot_h_sum : signed(38 downto 0) := (others => '0');
    signal dot_h_cut : signed(22 downto 0) := (others => '0');
    signal dot_h_over : unsigned(0 downto 0) := (others => '0');
    signal dot_h_under : unsigned(0 downto 0) := (others => '0');
    signal dot_h : signed(20 downto 0) := (others => '0'); -- s21f16
    signal diffuse_n2847 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal diffuse_n2848 : signed(20 downto 0) := (others => '0'); -- s21f16
    signal diffuse_n2849_over : unsigned(0 downto 0) := (others => '0');
    signal diffuse_n2849_under : unsigned(0 downto 0) := (others => '0');
    signal diffuse_n2849 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal diffuse_n2851 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal diffuse_n2852 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal n2858 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n2859 : signed(20 downto 0) := (others => '0'); -- s21f16
    signal specular_index_over : unsigned(0 downto 0) := (others => '0');
    signal specular_index_under : unsigned(0 downto 0) := (others => '0');
    signal specular_index : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal n2861 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n2862 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal n2863 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal specular_n2864 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal diffuse_n2852_s30 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal n2858_s30 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n2861_s30 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal specular_row : unsigned(15 downto 0) := (others => '0');
    signal valid_s30 : std_logic;
    -- stage 30
    signal diffuse_n2855 : unsigned(33 downto 0) := (others => '0'); -- u34f32
    signal specular_n2865 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal n2868 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal specular_next : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal diffuse_n2855_s31 : unsigned(33 downto 0) := (others => '0'); -- u34f32
    signal specular_next_s31 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s31 : std_logic;
    -- stage 31
    signal diffuse_n2856 : unsigned(34 downto 0) := (others => '0'); -- u35f32
    signal diffuse_diffuse_sum : unsigned(35 downto 0) := (others => '0');
    signal diffuse_diffuse_cut : unsigned(19 downto 0) := (others => '0');
    signal diffuse_diffuse_over : unsigned(0 downto 0) := (others => '0');
    signal diffuse_diffuse : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal n2870 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal diffuse_diffuse_s32 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal specular_next_s32 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal n2870_s32 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal valid_s32 : std_logic;
    -- stage 32
    signal intensity_next_over : unsigned(0 downto 0) := (others => '0');
    signal intensity_next : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s33 : std_logic;
begin

    -- ---- stage 0 ----
    -- setup.light
    setup_light_n18 <= t_x * l_x;
    setup_light_n19 <= t_y * l_y;
    setup_light_n20 <= t_z * l_z;
    setup_light_n24 <= b_x * l_x;
    setup_light_n25 <= b_y * l_y;
    setup_light_n26 <= b_z * l_z;
    setup_light_n30 <= n_x * l_x;
    setup_light_n31 <= n_y * l_y;
    setup_light_n32 <= n_z * l_z;
    -- setup.light.length
    setup_light_length_n42 <= "1";
    setup_light_length_n43 <= "0";
    setup_light_length_n327 <= setup_light_length_n43 & setup_light_length_n43;
    -- setup.light.unit_x
    setup_light_unit_x_n343 <= "1";
    setup_light_unit_x_n388 <= 23x"000000";
    setup_light_unit_x_n396 <= setup_light_length_n43 xor setup_light_length_n42;
    -- setup.half
    setup_half_n989 <= t_x * h_x;
    setup_half_n990 <= t_y * h_y;
    setup_half_n991 <= t_z * h_z;
    setup_half_n995 <= b_x * h_x;
    setup_half_n996 <= b_y * h_y;
    setup_half_n997 <= b_z * h_z;
    setup_half_n1001 <= n_x * h_x;
    setup_half_n1002 <= n_y * h_y;
    setup_half_n1003 <= n_z * h_z;
    -- setup.bump
    setup_bump_n1954 <= p_x * p_x;
    setup_bump_n1955 <= p_y * p_y;
    setup_bump_n1956 <= p_z * p_z;
    -- setup.bump.unit_x
    setup_bump_unit_x_n2215_neg <= unsigned(-p_x);
    setup_bump_unit_x_n2215 <= setup_bump_unit_x_n2215_neg when p_x(17) = '1' else unsigned(p_x);
    setup_bump_unit_x_n2217 <= setup_bump_unit_x_n2215(17 downto 17);
    setup_bump_unit_x_n2218 <= setup_bump_unit_x_n2215(16 downto 16);
    setup_bump_unit_x_n2219 <= setup_bump_unit_x_n2215(15 downto 15);
    setup_bump_unit_x_n2220 <= setup_bump_unit_x_n2215(14 downto 14);
    setup_bump_unit_x_n2221 <= setup_bump_unit_x_n2215(13 downto 13);
    setup_bump_unit_x_n2222 <= setup_bump_unit_x_n2215(12 downto 12);
    setup_bump_unit_x_n2223 <= setup_bump_unit_x_n2215(11 downto 11);
    setup_bump_unit_x_n2224 <= setup_bump_unit_x_n2215(10 downto 10);
    setup_bump_unit_x_n2225 <= setup_bump_unit_x_n2215(9 downto 9);
    setup_bump_unit_x_n2226 <= setup_bump_unit_x_n2215(8 downto 8);
    setup_bump_unit_x_n2227 <= setup_bump_unit_x_n2215(7 downto 7);
    setup_bump_unit_x_n2228 <= setup_bump_unit_x_n2215(6 downto 6);
    setup_bump_unit_x_n2229 <= setup_bump_unit_x_n2215(5 downto 5);
    setup_bump_unit_x_n2230 <= setup_bump_unit_x_n2215(4 downto 4);
    setup_bump_unit_x_n2231 <= setup_bump_unit_x_n2215(3 downto 3);
    setup_bump_unit_x_n2232 <= setup_bump_unit_x_n2215(2 downto 2);
    setup_bump_unit_x_n2233 <= setup_bump_unit_x_n2215(1 downto 1);
    setup_bump_unit_x_n2234 <= setup_bump_unit_x_n2215(0 downto 0);
    setup_bump_unit_x_n2235 <= setup_bump_unit_x_n2217 & setup_bump_unit_x_n2218;
    setup_bump_unit_x_n2236 <= setup_bump_unit_x_n2235 & setup_bump_unit_x_n2219;
    setup_bump_unit_x_n2237 <= setup_bump_unit_x_n2236 & setup_bump_unit_x_n2220;
    setup_bump_unit_x_n2238 <= setup_bump_unit_x_n2237 & setup_bump_unit_x_n2221;
    setup_bump_unit_x_n2239 <= setup_bump_unit_x_n2238 & setup_bump_unit_x_n2222;
    setup_bump_unit_x_n2240 <= setup_bump_unit_x_n2239 & setup_bump_unit_x_n2223;
    setup_bump_unit_x_n2241 <= setup_bump_unit_x_n2240 & setup_bump_unit_x_n2224;
    setup_bump_unit_x_n2242 <= setup_bump_unit_x_n2241 & setup_bump_unit_x_n2225;
    setup_bump_unit_x_n2243 <= setup_bump_unit_x_n2242 & setup_bump_unit_x_n2226;
    setup_bump_unit_x_n2244 <= setup_bump_unit_x_n2243 & setup_bump_unit_x_n2227;
    setup_bump_unit_x_n2245 <= setup_bump_unit_x_n2244 & setup_bump_unit_x_n2228;
    setup_bump_unit_x_n2246 <= setup_bump_unit_x_n2245 & setup_bump_unit_x_n2229;
    setup_bump_unit_x_n2247 <= setup_bump_unit_x_n2246 & setup_bump_unit_x_n2230;
    setup_bump_unit_x_n2248 <= setup_bump_unit_x_n2247 & setup_bump_unit_x_n2231;
    setup_bump_unit_x_n2249 <= setup_bump_unit_x_n2248 & setup_bump_unit_x_n2232;
    setup_bump_unit_x_n2250 <= setup_bump_unit_x_n2249 & setup_bump_unit_x_n2233;
    setup_bump_unit_x_n2251 <= setup_bump_unit_x_n2250 & setup_bump_unit_x_n2234;
    setup_bump_unit_x_n2254 <= setup_light_unit_x_n388 & setup_bump_unit_x_n2251;
    setup_bump_unit_x_n2255 <= setup_bump_unit_x_n2254(22 downto 0);
    setup_bump_unit_x_n2256 <= signed(resize(setup_bump_unit_x_n2255, 24));
    setup_bump_unit_x_n2257 <= unsigned(setup_bump_unit_x_n2256);
    setup_bump_unit_x_n2258 <= setup_bump_unit_x_n2257 & setup_light_length_n43;
    setup_bump_unit_x_n2259 <= signed(setup_bump_unit_x_n2258);
    setup_bump_unit_x_n2417 <= "1" when setup_bump_unit_x_n2215 = shift_left(resize(setup_light_length_n43, 18), 16) else "0";
    setup_bump_unit_x_n2419 <= unsigned(p_x(17 downto 17));
    -- setup.bump.unit_y
    setup_bump_unit_y_n2423_neg <= unsigned(-p_y);
    setup_bump_unit_y_n2423 <= setup_bump_unit_y_n2423_neg when p_y(17) = '1' else unsigned(p_y);
    setup_bump_unit_y_n2424 <= setup_bump_unit_y_n2423(17 downto 17);
    setup_bump_unit_y_n2425 <= setup_bump_unit_y_n2423(16 downto 16);
    setup_bump_unit_y_n2426 <= setup_bump_unit_y_n2423(15 downto 15);
    setup_bump_unit_y_n2427 <= setup_bump_unit_y_n2423(14 downto 14);
    setup_bump_unit_y_n2428 <= setup_bump_unit_y_n2423(13 downto 13);
    setup_bump_unit_y_n2429 <= setup_bump_unit_y_n2423(12 downto 12);
    setup_bump_unit_y_n2430 <= setup_bump_unit_y_n2423(11 downto 11);
    setup_bump_unit_y_n2431 <= setup_bump_unit_y_n2423(10 downto 10);
    setup_bump_unit_y_n2432 <= setup_bump_unit_y_n2423(9 downto 9);
    setup_bump_unit_y_n2433 <= setup_bump_unit_y_n2423(8 downto 8);
    setup_bump_unit_y_n2434 <= setup_bump_unit_y_n2423(7 downto 7);
    setup_bump_unit_y_n2435 <= setup_bump_unit_y_n2423(6 downto 6);
    setup_bump_unit_y_n2436 <= setup_bump_unit_y_n2423(5 downto 5);
    setup_bump_unit_y_n2437 <= setup_bump_unit_y_n2423(4 downto 4);
    setup_bump_unit_y_n2438 <= setup_bump_unit_y_n2423(3 downto 3);
    setup_bump_unit_y_n2439 <= setup_bump_unit_y_n2423(2 downto 2);
    setup_bump_unit_y_n2440 <= setup_bump_unit_y_n2423(1 downto 1);
    setup_bump_unit_y_n2441 <= setup_bump_unit_y_n2423(0 downto 0);
    setup_bump_unit_y_n2442 <= setup_bump_unit_y_n2424 & setup_bump_unit_y_n2425;
    setup_bump_unit_y_n2443 <= setup_bump_unit_y_n2442 & setup_bump_unit_y_n2426;
    setup_bump_unit_y_n2444 <= setup_bump_unit_y_n2443 & setup_bump_unit_y_n2427;
    setup_bump_unit_y_n2445 <= setup_bump_unit_y_n2444 & setup_bump_unit_y_n2428;
    setup_bump_unit_y_n2446 <= setup_bump_unit_y_n2445 & setup_bump_unit_y_n2429;
    setup_bump_unit_y_n2447 <= setup_bump_unit_y_n2446 & setup_bump_unit_y_n2430;
    setup_bump_unit_y_n2448 <= setup_bump_unit_y_n2447 & setup_bump_unit_y_n2431;
    setup_bump_unit_y_n2449 <= setup_bump_unit_y_n2448 & setup_bump_unit_y_n2432;
    setup_bump_unit_y_n2450 <= setup_bump_unit_y_n2449 & setup_bump_unit_y_n2433;
    setup_bump_unit_y_n2451 <= setup_bump_unit_y_n2450 & setup_bump_unit_y_n2434;
    setup_bump_unit_y_n2452 <= setup_bump_unit_y_n2451 & setup_bump_unit_y_n2435;
    setup_bump_unit_y_n2453 <= setup_bump_unit_y_n2452 & setup_bump_unit_y_n2436;
    setup_bump_unit_y_n2454 <= setup_bump_unit_y_n2453 & setup_bump_unit_y_n2437;
    setup_bump_unit_y_n2455 <= setup_bump_unit_y_n2454 & setup_bump_unit_y_n2438;
    setup_bump_unit_y_n2456 <= setup_bump_unit_y_n2455 & setup_bump_unit_y_n2439;
    setup_bump_unit_y_n2457 <= setup_bump_unit_y_n2456 & setup_bump_unit_y_n2440;
    setup_bump_unit_y_n2458 <= setup_bump_unit_y_n2457 & setup_bump_unit_y_n2441;
    setup_bump_unit_y_n2461 <= setup_light_unit_x_n388 & setup_bump_unit_y_n2458;
    setup_bump_unit_y_n2462 <= setup_bump_unit_y_n2461(22 downto 0);
    setup_bump_unit_y_n2463 <= signed(resize(setup_bump_unit_y_n2462, 24));
    setup_bump_unit_y_n2464 <= unsigned(setup_bump_unit_y_n2463);
    setup_bump_unit_y_n2465 <= setup_bump_unit_y_n2464 & setup_light_length_n43;
    setup_bump_unit_y_n2466 <= signed(setup_bump_unit_y_n2465);
    setup_bump_unit_y_n2623 <= "1" when setup_bump_unit_y_n2423 = shift_left(resize(setup_light_length_n43, 18), 16) else "0";
    setup_bump_unit_y_n2625 <= unsigned(p_y(17 downto 17));
    -- setup.bump.unit_z
    setup_bump_unit_z_n2629_neg <= unsigned(-p_z);
    setup_bump_unit_z_n2629 <= setup_bump_unit_z_n2629_neg when p_z(17) = '1' else unsigned(p_z);
    setup_bump_unit_z_n2630 <= setup_bump_unit_z_n2629(17 downto 17);
    setup_bump_unit_z_n2631 <= setup_bump_unit_z_n2629(16 downto 16);
    setup_bump_unit_z_n2632 <= setup_bump_unit_z_n2629(15 downto 15);
    setup_bump_unit_z_n2633 <= setup_bump_unit_z_n2629(14 downto 14);
    setup_bump_unit_z_n2634 <= setup_bump_unit_z_n2629(13 downto 13);
    setup_bump_unit_z_n2635 <= setup_bump_unit_z_n2629(12 downto 12);
    setup_bump_unit_z_n2636 <= setup_bump_unit_z_n2629(11 downto 11);
    setup_bump_unit_z_n2637 <= setup_bump_unit_z_n2629(10 downto 10);
    setup_bump_unit_z_n2638 <= setup_bump_unit_z_n2629(9 downto 9);
    setup_bump_unit_z_n2639 <= setup_bump_unit_z_n2629(8 downto 8);
    setup_bump_unit_z_n2640 <= setup_bump_unit_z_n2629(7 downto 7);
    setup_bump_unit_z_n2641 <= setup_bump_unit_z_n2629(6 downto 6);
    setup_bump_unit_z_n2642 <= setup_bump_unit_z_n2629(5 downto 5);
    setup_bump_unit_z_n2643 <= setup_bump_unit_z_n2629(4 downto 4);
    setup_bump_unit_z_n2644 <= setup_bump_unit_z_n2629(3 downto 3);
    setup_bump_unit_z_n2645 <= setup_bump_unit_z_n2629(2 downto 2);
    setup_bump_unit_z_n2646 <= setup_bump_unit_z_n2629(1 downto 1);
    setup_bump_unit_z_n2647 <= setup_bump_unit_z_n2629(0 downto 0);
    setup_bump_unit_z_n2648 <= setup_bump_unit_z_n2630 & setup_bump_unit_z_n2631;
    setup_bump_unit_z_n2649 <= setup_bump_unit_z_n2648 & setup_bump_unit_z_n2632;
    setup_bump_unit_z_n2650 <= setup_bump_unit_z_n2649 & setup_bump_unit_z_n2633;
    setup_bump_unit_z_n2651 <= setup_bump_unit_z_n2650 & setup_bump_unit_z_n2634;
    setup_bump_unit_z_n2652 <= setup_bump_unit_z_n2651 & setup_bump_unit_z_n2635;
    setup_bump_unit_z_n2653 <= setup_bump_unit_z_n2652 & setup_bump_unit_z_n2636;
    setup_bump_unit_z_n2654 <= setup_bump_unit_z_n2653 & setup_bump_unit_z_n2637;
    setup_bump_unit_z_n2655 <= setup_bump_unit_z_n2654 & setup_bump_unit_z_n2638;
    setup_bump_unit_z_n2656 <= setup_bump_unit_z_n2655 & setup_bump_unit_z_n2639;
    setup_bump_unit_z_n2657 <= setup_bump_unit_z_n2656 & setup_bump_unit_z_n2640;
    setup_bump_unit_z_n2658 <= setup_bump_unit_z_n2657 & setup_bump_unit_z_n2641;
    setup_bump_unit_z_n2659 <= setup_bump_unit_z_n2658 & setup_bump_unit_z_n2642;
    setup_bump_unit_z_n2660 <= setup_bump_unit_z_n2659 & setup_bump_unit_z_n2643;
    setup_bump_unit_z_n2661 <= setup_bump_unit_z_n2660 & setup_bump_unit_z_n2644;
    setup_bump_unit_z_n2662 <= setup_bump_unit_z_n2661 & setup_bump_unit_z_n2645;
    setup_bump_unit_z_n2663 <= setup_bump_unit_z_n2662 & setup_bump_unit_z_n2646;
    setup_bump_unit_z_n2664 <= setup_bump_unit_z_n2663 & setup_bump_unit_z_n2647;
    setup_bump_unit_z_n2667 <= setup_light_unit_x_n388 & setup_bump_unit_z_n2664;
    setup_bump_unit_z_n2668 <= setup_bump_unit_z_n2667(22 downto 0);
    setup_bump_unit_z_n2669 <= signed(resize(setup_bump_unit_z_n2668, 24));
    setup_bump_unit_z_n2670 <= unsigned(setup_bump_unit_z_n2669);
    setup_bump_unit_z_n2671 <= setup_bump_unit_z_n2670 & setup_light_length_n43;
    setup_bump_unit_z_n2672 <= signed(setup_bump_unit_z_n2671);
    setup_bump_unit_z_n2829 <= "1" when setup_bump_unit_z_n2629 = shift_left(resize(setup_light_length_n43, 18), 16) else "0";
    setup_bump_unit_z_n2831 <= unsigned(p_z(17 downto 17));
    -- diffuse
    diffuse_n2850 <= 17x"10000";
    diffuse_n2853 <= 17x"0999a";
    diffuse_n2854 <= 17x"0199a";
    -- (unit)
    n2866 <= 16x"4ccd";
    n2867 <= 16x"0000";

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_n18_s1 <= setup_light_n18;
                setup_light_n19_s1 <= setup_light_n19;
                setup_light_n20_s1 <= setup_light_n20;
                setup_light_n24_s1 <= setup_light_n24;
                setup_light_n25_s1 <= setup_light_n25;
                setup_light_n26_s1 <= setup_light_n26;
                setup_light_n30_s1 <= setup_light_n30;
                setup_light_n31_s1 <= setup_light_n31;
                setup_light_n32_s1 <= setup_light_n32;
                setup_light_length_n327_s1 <= setup_light_length_n327;
                setup_light_unit_x_n396_s1 <= setup_light_unit_x_n396;
                setup_half_n989_s1 <= setup_half_n989;
                setup_half_n990_s1 <= setup_half_n990;
                setup_half_n991_s1 <= setup_half_n991;
                setup_half_n995_s1 <= setup_half_n995;
                setup_half_n996_s1 <= setup_half_n996;
                setup_half_n997_s1 <= setup_half_n997;
                setup_half_n1001_s1 <= setup_half_n1001;
                setup_half_n1002_s1 <= setup_half_n1002;
                setup_half_n1003_s1 <= setup_half_n1003;
                setup_bump_n1954_s1 <= setup_bump_n1954;
                setup_bump_n1955_s1 <= setup_bump_n1955;
                setup_bump_n1956_s1 <= setup_bump_n1956;
                setup_bump_unit_x_n2251_s1 <= setup_bump_unit_x_n2251;
                setup_bump_unit_x_n2259_s1 <= setup_bump_unit_x_n2259;
                setup_bump_unit_x_n2417_s1 <= setup_bump_unit_x_n2417;
                setup_bump_unit_x_n2419_s1 <= setup_bump_unit_x_n2419;
                setup_bump_unit_y_n2458_s1 <= setup_bump_unit_y_n2458;
                setup_bump_unit_y_n2466_s1 <= setup_bump_unit_y_n2466;
                setup_bump_unit_y_n2623_s1 <= setup_bump_unit_y_n2623;
                setup_bump_unit_y_n2625_s1 <= setup_bump_unit_y_n2625;
                setup_bump_unit_z_n2664_s1 <= setup_bump_unit_z_n2664;
                setup_bump_unit_z_n2672_s1 <= setup_bump_unit_z_n2672;
                setup_bump_unit_z_n2829_s1 <= setup_bump_unit_z_n2829;
                setup_bump_unit_z_n2831_s1 <= setup_bump_unit_z_n2831;
            end if;
            if rst = '1' then
                valid_s1 <= '0';
            elsif ce = '1' then
                valid_s1 <= valid_in;
            end if;
        end if;
    end process;

    -- ---- stage 1 ----
    -- setup.light
    setup_light_n21 <= resize(setup_light_n18_s1, 37) + resize(setup_light_n19_s1, 37);
    setup_light_n22 <= resize(setup_light_n21, 38) + resize(setup_light_n20_s1, 38);
    setup_light_n27 <= resize(setup_light_n24_s1, 37) + resize(setup_light_n25_s1, 37);
    setup_light_n28 <= resize(setup_light_n27, 38) + resize(setup_light_n26_s1, 38);
    setup_light_n33 <= resize(setup_light_n30_s1, 37) + resize(setup_light_n31_s1, 37);
    setup_light_n34 <= resize(setup_light_n33, 38) + resize(setup_light_n32_s1, 38);
    -- setup.half
    setup_half_n992 <= resize(setup_half_n989_s1, 37) + resize(setup_half_n990_s1, 37);
    setup_half_n993 <= resize(setup_half_n992, 38) + resize(setup_half_n991_s1, 38);
    setup_half_n998 <= resize(setup_half_n995_s1, 37) + resize(setup_half_n996_s1, 37);
    setup_half_n999 <= resize(setup_half_n998, 38) + resize(setup_half_n997_s1, 38);
    setup_half_n1004 <= resize(setup_half_n1001_s1, 37) + resize(setup_half_n1002_s1, 37);
    setup_half_n1005 <= resize(setup_half_n1004, 38) + resize(setup_half_n1003_s1, 38);
    -- setup.bump
    setup_bump_n1957 <= resize(setup_bump_n1954_s1, 37) + resize(setup_bump_n1955_s1, 37);
    setup_bump_n1958 <= resize(setup_bump_n1957, 38) + resize(setup_bump_n1956_s1, 38);
    setup_bump_square_under <= unsigned(setup_bump_n1958(37 downto 37));
    setup_bump_square <= 37x"0000000000" when setup_bump_square_under(0) = '1' else unsigned(setup_bump_n1958(36 downto 0));
    -- setup.bump.length
    setup_bump_length_n1960 <= setup_bump_square(36 downto 36);
    setup_bump_length_n1961 <= setup_light_length_n43 & setup_bump_length_n1960;
    setup_bump_length_n1962 <= signed(resize(setup_bump_length_n1961, 3)) - signed(resize(setup_light_length_n42, 3));
    setup_bump_length_n1963 <= unsigned(setup_bump_length_n1962(2 downto 2));
    setup_bump_length_n1967 <= setup_bump_square(35 downto 35);
    setup_bump_length_n1968 <= setup_bump_square(34 downto 34);
    setup_bump_length_n1969 <= setup_bump_length_n1967 & setup_bump_length_n1968;
    setup_bump_length_n1979 <= setup_bump_square(33 downto 33);
    setup_bump_length_n1980 <= setup_bump_square(32 downto 32);
    setup_bump_length_n1981 <= setup_bump_length_n1979 & setup_bump_length_n1980;
    setup_bump_length_n1991 <= setup_bump_square(31 downto 31);
    setup_bump_length_n1992 <= setup_bump_square(30 downto 30);
    setup_bump_length_n1993 <= setup_bump_length_n1991 & setup_bump_length_n1992;
    setup_bump_length_n2003 <= setup_bump_square(29 downto 29);
    setup_bump_length_n2004 <= setup_bump_square(28 downto 28);
    setup_bump_length_n2005 <= setup_bump_length_n2003 & setup_bump_length_n2004;
    setup_bump_length_n2015 <= setup_bump_square(27 downto 27);
    setup_bump_length_n2016 <= setup_bump_square(26 downto 26);
    setup_bump_length_n2017 <= setup_bump_length_n2015 & setup_bump_length_n2016;
    setup_bump_length_n2027 <= setup_bump_square(25 downto 25);
    setup_bump_length_n2028 <= setup_bump_square(24 downto 24);
    setup_bump_length_n2029 <= setup_bump_length_n2027 & setup_bump_length_n2028;
    setup_bump_length_n2039 <= setup_bump_square(23 downto 23);
    setup_bump_length_n2040 <= setup_bump_square(22 downto 22);
    setup_bump_length_n2041 <= setup_bump_length_n2039 & setup_bump_length_n2040;
    setup_bump_length_n2051 <= setup_bump_square(21 downto 21);
    setup_bump_length_n2052 <= setup_bump_square(20 downto 20);
    setup_bump_length_n2053 <= setup_bump_length_n2051 & setup_bump_length_n2052;
    setup_bump_length_n2063 <= setup_bump_square(19 downto 19);
    setup_bump_length_n2064 <= setup_bump_square(18 downto 18);
    setup_bump_length_n2065 <= setup_bump_length_n2063 & setup_bump_length_n2064;
    setup_bump_length_n2075 <= setup_bump_square(17 downto 17);
    setup_bump_length_n2076 <= setup_bump_square(16 downto 16);
    setup_bump_length_n2077 <= setup_bump_length_n2075 & setup_bump_length_n2076;
    setup_bump_length_n2087 <= setup_bump_square(15 downto 15);
    setup_bump_length_n2088 <= setup_bump_square(14 downto 14);
    setup_bump_length_n2089 <= setup_bump_length_n2087 & setup_bump_length_n2088;
    setup_bump_length_n2099 <= setup_bump_square(13 downto 13);
    setup_bump_length_n2100 <= setup_bump_square(12 downto 12);
    setup_bump_length_n2101 <= setup_bump_length_n2099 & setup_bump_length_n2100;
    setup_bump_length_n2111 <= setup_bump_square(11 downto 11);
    setup_bump_length_n2112 <= setup_bump_square(10 downto 10);
    setup_bump_length_n2113 <= setup_bump_length_n2111 & setup_bump_length_n2112;
    setup_bump_length_n2123 <= setup_bump_square(9 downto 9);
    setup_bump_length_n2124 <= setup_bump_square(8 downto 8);
    setup_bump_length_n2125 <= setup_bump_length_n2123 & setup_bump_length_n2124;
    setup_bump_length_n2135 <= setup_bump_square(7 downto 7);
    setup_bump_length_n2136 <= setup_bump_square(6 downto 6);
    setup_bump_length_n2137 <= setup_bump_length_n2135 & setup_bump_length_n2136;
    setup_bump_length_n2147 <= setup_bump_square(5 downto 5);
    setup_bump_length_n2148 <= setup_bump_square(4 downto 4);
    setup_bump_length_n2149 <= setup_bump_length_n2147 & setup_bump_length_n2148;
    setup_bump_length_n2159 <= setup_bump_square(3 downto 3);
    setup_bump_length_n2160 <= setup_bump_square(2 downto 2);
    setup_bump_length_n2161 <= setup_bump_length_n2159 & setup_bump_length_n2160;
    setup_bump_length_n2171 <= setup_bump_square(1 downto 1);
    setup_bump_length_n2172 <= setup_bump_square(0 downto 0);
    setup_bump_length_n2173 <= setup_bump_length_n2171 & setup_bump_length_n2172;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_n22_s2 <= setup_light_n22;
                setup_light_n28_s2 <= setup_light_n28;
                setup_light_n34_s2 <= setup_light_n34;
                setup_light_length_n327_s2 <= setup_light_length_n327_s1;
                setup_light_unit_x_n396_s2 <= setup_light_unit_x_n396_s1;
                setup_half_n993_s2 <= setup_half_n993;
                setup_half_n999_s2 <= setup_half_n999;
                setup_half_n1005_s2 <= setup_half_n1005;
                setup_bump_length_n1961_s2 <= setup_bump_length_n1961;
                setup_bump_length_n1962_s2 <= setup_bump_length_n1962;
                setup_bump_length_n1963_s2 <= setup_bump_length_n1963;
                setup_bump_length_n1969_s2 <= setup_bump_length_n1969;
                setup_bump_length_n1981_s2 <= setup_bump_length_n1981;
                setup_bump_length_n1993_s2 <= setup_bump_length_n1993;
                setup_bump_length_n2005_s2 <= setup_bump_length_n2005;
                setup_bump_length_n2017_s2 <= setup_bump_length_n2017;
                setup_bump_length_n2029_s2 <= setup_bump_length_n2029;
                setup_bump_length_n2041_s2 <= setup_bump_length_n2041;
                setup_bump_length_n2053_s2 <= setup_bump_length_n2053;
                setup_bump_length_n2065_s2 <= setup_bump_length_n2065;
                setup_bump_length_n2077_s2 <= setup_bump_length_n2077;
                setup_bump_length_n2089_s2 <= setup_bump_length_n2089;
                setup_bump_length_n2101_s2 <= setup_bump_length_n2101;
                setup_bump_length_n2113_s2 <= setup_bump_length_n2113;
                setup_bump_length_n2125_s2 <= setup_bump_length_n2125;
                setup_bump_length_n2137_s2 <= setup_bump_length_n2137;
                setup_bump_length_n2149_s2 <= setup_bump_length_n2149;
                setup_bump_length_n2161_s2 <= setup_bump_length_n2161;
                setup_bump_length_n2173_s2 <= setup_bump_length_n2173;
                setup_bump_unit_x_n2251_s2 <= setup_bump_unit_x_n2251_s1;
                setup_bump_unit_x_n2259_s2 <= setup_bump_unit_x_n2259_s1;
                setup_bump_unit_x_n2417_s2 <= setup_bump_unit_x_n2417_s1;
                setup_bump_unit_x_n2419_s2 <= setup_bump_unit_x_n2419_s1;
                setup_bump_unit_y_n2458_s2 <= setup_bump_unit_y_n2458_s1;
                setup_bump_unit_y_n2466_s2 <= setup_bump_unit_y_n2466_s1;
                setup_bump_unit_y_n2623_s2 <= setup_bump_unit_y_n2623_s1;
                setup_bump_unit_y_n2625_s2 <= setup_bump_unit_y_n2625_s1;
                setup_bump_unit_z_n2664_s2 <= setup_bump_unit_z_n2664_s1;
                setup_bump_unit_z_n2672_s2 <= setup_bump_unit_z_n2672_s1;
                setup_bump_unit_z_n2829_s2 <= setup_bump_unit_z_n2829_s1;
                setup_bump_unit_z_n2831_s2 <= setup_bump_unit_z_n2831_s1;
            end if;
            if rst = '1' then
                valid_s2 <= '0';
            elsif ce = '1' then
                valid_s2 <= valid_s1;
            end if;
        end if;
    end process;

    -- ---- stage 2 ----
    -- setup.light
    setup_light_frame_x_sum <= resize(setup_light_n22_s2, 39) + 39x"0000002000";
    setup_light_frame_x_cut <= setup_light_frame_x_sum(38 downto 14);
    setup_light_frame_x_over <= "1" when setup_light_frame_x_cut(24) = '0' and (or setup_light_frame_x_cut(23 downto 22)) = '1' else "0";
    setup_light_frame_x_under <= "1" when setup_light_frame_x_cut(24) = '1' and (and setup_light_frame_x_cut(23 downto 22)) = '0' else "0";
    setup_light_frame_x <= 23x"3fffff" when setup_light_frame_x_over(0) = '1' else 23x"400000" when setup_light_frame_x_under(0) = '1' else setup_light_frame_x_cut(22 downto 0);
    setup_light_frame_y_sum <= resize(setup_light_n28_s2, 39) + 39x"0000002000";
    setup_light_frame_y_cut <= setup_light_frame_y_sum(38 downto 14);
    setup_light_frame_y_over <= "1" when setup_light_frame_y_cut(24) = '0' and (or setup_light_frame_y_cut(23 downto 22)) = '1' else "0";
    setup_light_frame_y_under <= "1" when setup_light_frame_y_cut(24) = '1' and (and setup_light_frame_y_cut(23 downto 22)) = '0' else "0";
    setup_light_frame_y <= 23x"3fffff" when setup_light_frame_y_over(0) = '1' else 23x"400000" when setup_light_frame_y_under(0) = '1' else setup_light_frame_y_cut(22 downto 0);
    setup_light_frame_z_sum <= resize(setup_light_n34_s2, 39) + 39x"0000002000";
    setup_light_frame_z_cut <= setup_light_frame_z_sum(38 downto 14);
    setup_light_frame_z_over <= "1" when setup_light_frame_z_cut(24) = '0' and (or setup_light_frame_z_cut(23 downto 22)) = '1' else "0";
    setup_light_frame_z_under <= "1" when setup_light_frame_z_cut(24) = '1' and (and setup_light_frame_z_cut(23 downto 22)) = '0' else "0";
    setup_light_frame_z <= 23x"3fffff" when setup_light_frame_z_over(0) = '1' else 23x"400000" when setup_light_frame_z_under(0) = '1' else setup_light_frame_z_cut(22 downto 0);
    -- setup.light.unit_x
    setup_light_unit_x_n342_neg <= unsigned(-setup_light_frame_x);
    setup_light_unit_x_n342 <= setup_light_unit_x_n342_neg when setup_light_frame_x(22) = '1' else unsigned(setup_light_frame_x);
    setup_light_unit_x_n345 <= setup_light_unit_x_n342(22 downto 22);
    setup_light_unit_x_n346 <= setup_light_unit_x_n342(21 downto 21);
    setup_light_unit_x_n347 <= setup_light_unit_x_n342(20 downto 20);
    setup_light_unit_x_n348 <= setup_light_unit_x_n342(19 downto 19);
    setup_light_unit_x_n349 <= setup_light_unit_x_n342(18 downto 18);
    setup_light_unit_x_n350 <= setup_light_unit_x_n342(17 downto 17);
    setup_light_unit_x_n351 <= setup_light_unit_x_n342(16 downto 16);
    setup_light_unit_x_n352 <= setup_light_unit_x_n342(15 downto 15);
    setup_light_unit_x_n353 <= setup_light_unit_x_n342(14 downto 14);
    setup_light_unit_x_n354 <= setup_light_unit_x_n342(13 downto 13);
    setup_light_unit_x_n355 <= setup_light_unit_x_n342(12 downto 12);
    setup_light_unit_x_n356 <= setup_light_unit_x_n342(11 downto 11);
    setup_light_unit_x_n357 <= setup_light_unit_x_n342(10 downto 10);
    setup_light_unit_x_n358 <= setup_light_unit_x_n342(9 downto 9);
    setup_light_unit_x_n359 <= setup_light_unit_x_n342(8 downto 8);
    setup_light_unit_x_n360 <= setup_light_unit_x_n342(7 downto 7);
    setup_light_unit_x_n361 <= setup_light_unit_x_n342(6 downto 6);
    setup_light_unit_x_n362 <= setup_light_unit_x_n342(5 downto 5);
    setup_light_unit_x_n363 <= setup_light_unit_x_n342(4 downto 4);
    setup_light_unit_x_n364 <= setup_light_unit_x_n342(3 downto 3);
    setup_light_unit_x_n365 <= setup_light_unit_x_n342(2 downto 2);
    setup_light_unit_x_n366 <= setup_light_unit_x_n345 & setup_light_unit_x_n346;
    setup_light_unit_x_n367 <= setup_light_unit_x_n366 & setup_light_unit_x_n347;
    setup_light_unit_x_n368 <= setup_light_unit_x_n367 & setup_light_unit_x_n348;
    setup_light_unit_x_n369 <= setup_light_unit_x_n368 & setup_light_unit_x_n349;
    setup_light_unit_x_n370 <= setup_light_unit_x_n369 & setup_light_unit_x_n350;
    setup_light_unit_x_n371 <= setup_light_unit_x_n370 & setup_light_unit_x_n351;
    setup_light_unit_x_n372 <= setup_light_unit_x_n371 & setup_light_unit_x_n352;
    setup_light_unit_x_n373 <= setup_light_unit_x_n372 & setup_light_unit_x_n353;
    setup_light_unit_x_n374 <= setup_light_unit_x_n373 & setup_light_unit_x_n354;
    setup_light_unit_x_n375 <= setup_light_unit_x_n374 & setup_light_unit_x_n355;
    setup_light_unit_x_n376 <= setup_light_unit_x_n375 & setup_light_unit_x_n356;
    setup_light_unit_x_n377 <= setup_light_unit_x_n376 & setup_light_unit_x_n357;
    setup_light_unit_x_n378 <= setup_light_unit_x_n377 & setup_light_unit_x_n358;
    setup_light_unit_x_n379 <= setup_light_unit_x_n378 & setup_light_unit_x_n359;
    setup_light_unit_x_n380 <= setup_light_unit_x_n379 & setup_light_unit_x_n360;
    setup_light_unit_x_n381 <= setup_light_unit_x_n380 & setup_light_unit_x_n361;
    setup_light_unit_x_n382 <= setup_light_unit_x_n381 & setup_light_unit_x_n362;
    setup_light_unit_x_n383 <= setup_light_unit_x_n382 & setup_light_unit_x_n363;
    setup_light_unit_x_n384 <= setup_light_unit_x_n383 & setup_light_unit_x_n364;
    setup_light_unit_x_n385 <= setup_light_unit_x_n384 & setup_light_unit_x_n365;
    setup_light_unit_x_n389 <= setup_light_unit_x_n388 & setup_light_unit_x_n385;
    setup_light_unit_x_n390 <= setup_light_unit_x_n389(22 downto 0);
    setup_light_unit_x_n391 <= signed(resize(setup_light_unit_x_n390, 24));
    setup_light_unit_x_n392 <= unsigned(setup_light_unit_x_n391);
    setup_light_unit_x_n393 <= setup_light_unit_x_n342(1 downto 1);
    setup_light_unit_x_n394 <= setup_light_unit_x_n392 & setup_light_unit_x_n393;
    setup_light_unit_x_n395 <= signed(setup_light_unit_x_n394);
    setup_light_unit_x_n402 <= setup_light_unit_x_n342(0 downto 0);
    setup_light_unit_x_n555 <= "1" when setup_light_unit_x_n342 = shift_left(resize(setup_light_length_n43, 23), 18) else "0";
    setup_light_unit_x_n557 <= unsigned(setup_light_frame_x(22 downto 22));
    -- setup.light.unit_y
    setup_light_unit_y_n561_neg <= unsigned(-setup_light_frame_y);
    setup_light_unit_y_n561 <= setup_light_unit_y_n561_neg when setup_light_frame_y(22) = '1' else unsigned(setup_light_frame_y);
    setup_light_unit_y_n562 <= setup_light_unit_y_n561(22 downto 22);
    setup_light_unit_y_n563 <= setup_light_unit_y_n561(21 downto 21);
    setup_light_unit_y_n564 <= setup_light_unit_y_n561(20 downto 20);
    setup_light_unit_y_n565 <= setup_light_unit_y_n561(19 downto 19);
    setup_light_unit_y_n566 <= setup_light_unit_y_n561(18 downto 18);
    setup_light_unit_y_n567 <= setup_light_unit_y_n561(17 downto 17);
    setup_light_unit_y_n568 <= setup_light_unit_y_n561(16 downto 16);
    setup_light_unit_y_n569 <= setup_light_unit_y_n561(15 downto 15);
    setup_light_unit_y_n570 <= setup_light_unit_y_n561(14 downto 14);
    setup_light_unit_y_n571 <= setup_light_unit_y_n561(13 downto 13);
    setup_light_unit_y_n572 <= setup_light_unit_y_n561(12 downto 12);
    setup_light_unit_y_n573 <= setup_light_unit_y_n561(11 downto 11);
    setup_light_unit_y_n574 <= setup_light_unit_y_n561(10 downto 10);
    setup_light_unit_y_n575 <= setup_light_unit_y_n561(9 downto 9);
    setup_light_unit_y_n576 <= setup_light_unit_y_n561(8 downto 8);
    setup_light_unit_y_n577 <= setup_light_unit_y_n561(7 downto 7);
    setup_light_unit_y_n578 <= setup_light_unit_y_n561(6 downto 6);
    setup_light_unit_y_n579 <= setup_light_unit_y_n561(5 downto 5);
    setup_light_unit_y_n580 <= setup_light_unit_y_n561(4 downto 4);
    setup_light_unit_y_n581 <= setup_light_unit_y_n561(3 downto 3);
    setup_light_unit_y_n582 <= setup_light_unit_y_n561(2 downto 2);
    setup_light_unit_y_n583 <= setup_light_unit_y_n562 & setup_light_unit_y_n563;
    setup_light_unit_y_n584 <= setup_light_unit_y_n583 & setup_light_unit_y_n564;
    setup_light_unit_y_n585 <= setup_light_unit_y_n584 & setup_light_unit_y_n565;
    setup_light_unit_y_n586 <= setup_light_unit_y_n585 & setup_light_unit_y_n566;
    setup_light_unit_y_n587 <= setup_light_unit_y_n586 & setup_light_unit_y_n567;
    setup_light_unit_y_n588 <= setup_light_unit_y_n587 & setup_light_unit_y_n568;
    setup_light_unit_y_n589 <= setup_light_unit_y_n588 & setup_light_unit_y_n569;
    setup_light_unit_y_n590 <= setup_light_unit_y_n589 & setup_light_unit_y_n570;
    setup_light_unit_y_n591 <= setup_light_unit_y_n590 & setup_light_unit_y_n571;
    setup_light_unit_y_n592 <= setup_light_unit_y_n591 & setup_light_unit_y_n572;
    setup_light_unit_y_n593 <= setup_light_unit_y_n592 & setup_light_unit_y_n573;
    setup_light_unit_y_n594 <= setup_light_unit_y_n593 & setup_light_unit_y_n574;
    setup_light_unit_y_n595 <= setup_light_unit_y_n594 & setup_light_unit_y_n575;
    setup_light_unit_y_n596 <= setup_light_unit_y_n595 & setup_light_unit_y_n576;
    setup_light_unit_y_n597 <= setup_light_unit_y_n596 & setup_light_unit_y_n577;
    setup_light_unit_y_n598 <= setup_light_unit_y_n597 & setup_light_unit_y_n578;
    setup_light_unit_y_n599 <= setup_light_unit_y_n598 & setup_light_unit_y_n579;
    setup_light_unit_y_n600 <= setup_light_unit_y_n599 & setup_light_unit_y_n580;
    setup_light_unit_y_n601 <= setup_light_unit_y_n600 & setup_light_unit_y_n581;
    setup_light_unit_y_n602 <= setup_light_unit_y_n601 & setup_light_unit_y_n582;
    setup_light_unit_y_n605 <= setup_light_unit_x_n388 & setup_light_unit_y_n602;
    setup_light_unit_y_n606 <= setup_light_unit_y_n605(22 downto 0);
    setup_light_unit_y_n607 <= signed(resize(setup_light_unit_y_n606, 24));
    setup_light_unit_y_n608 <= unsigned(setup_light_unit_y_n607);
    setup_light_unit_y_n609 <= setup_light_unit_y_n561(1 downto 1);
    setup_light_unit_y_n610 <= setup_light_unit_y_n608 & setup_light_unit_y_n609;
    setup_light_unit_y_n611 <= signed(setup_light_unit_y_n610);
    setup_light_unit_y_n617 <= setup_light_unit_y_n561(0 downto 0);
    setup_light_unit_y_n769 <= "1" when setup_light_unit_y_n561 = shift_left(resize(setup_light_length_n43, 23), 18) else "0";
    setup_light_unit_y_n771 <= unsigned(setup_light_frame_y(22 downto 22));
    -- setup.light.unit_z
    setup_light_unit_z_n775_neg <= unsigned(-setup_light_frame_z);
    setup_light_unit_z_n775 <= setup_light_unit_z_n775_neg when setup_light_frame_z(22) = '1' else unsigned(setup_light_frame_z);
    setup_light_unit_z_n776 <= setup_light_unit_z_n775(22 downto 22);
    setup_light_unit_z_n777 <= setup_light_unit_z_n775(21 downto 21);
    setup_light_unit_z_n778 <= setup_light_unit_z_n775(20 downto 20);
    setup_light_unit_z_n779 <= setup_light_unit_z_n775(19 downto 19);
    setup_light_unit_z_n780 <= setup_light_unit_z_n775(18 downto 18);
    setup_light_unit_z_n781 <= setup_light_unit_z_n775(17 downto 17);
    setup_light_unit_z_n782 <= setup_light_unit_z_n775(16 downto 16);
    setup_light_unit_z_n783 <= setup_light_unit_z_n775(15 downto 15);
    setup_light_unit_z_n784 <= setup_light_unit_z_n775(14 downto 14);
    setup_light_unit_z_n785 <= setup_light_unit_z_n775(13 downto 13);
    setup_light_unit_z_n786 <= setup_light_unit_z_n775(12 downto 12);
    setup_light_unit_z_n787 <= setup_light_unit_z_n775(11 downto 11);
    setup_light_unit_z_n788 <= setup_light_unit_z_n775(10 downto 10);
    setup_light_unit_z_n789 <= setup_light_unit_z_n775(9 downto 9);
    setup_light_unit_z_n790 <= setup_light_unit_z_n775(8 downto 8);
    setup_light_unit_z_n791 <= setup_light_unit_z_n775(7 downto 7);
    setup_light_unit_z_n792 <= setup_light_unit_z_n775(6 downto 6);
    setup_light_unit_z_n793 <= setup_light_unit_z_n775(5 downto 5);
    setup_light_unit_z_n794 <= setup_light_unit_z_n775(4 downto 4);
    setup_light_unit_z_n795 <= setup_light_unit_z_n775(3 downto 3);
    setup_light_unit_z_n796 <= setup_light_unit_z_n775(2 downto 2);
    setup_light_unit_z_n797 <= setup_light_unit_z_n776 & setup_light_unit_z_n777;
    setup_light_unit_z_n798 <= setup_light_unit_z_n797 & setup_light_unit_z_n778;
    setup_light_unit_z_n799 <= setup_light_unit_z_n798 & setup_light_unit_z_n779;
    setup_light_unit_z_n800 <= setup_light_unit_z_n799 & setup_light_unit_z_n780;
    setup_light_unit_z_n801 <= setup_light_unit_z_n800 & setup_light_unit_z_n781;
    setup_light_unit_z_n802 <= setup_light_unit_z_n801 & setup_light_unit_z_n782;
    setup_light_unit_z_n803 <= setup_light_unit_z_n802 & setup_light_unit_z_n783;
    setup_light_unit_z_n804 <= setup_light_unit_z_n803 & setup_light_unit_z_n784;
    setup_light_unit_z_n805 <= setup_light_unit_z_n804 & setup_light_unit_z_n785;
    setup_light_unit_z_n806 <= setup_light_unit_z_n805 & setup_light_unit_z_n786;
    setup_light_unit_z_n807 <= setup_light_unit_z_n806 & setup_light_unit_z_n787;
    setup_light_unit_z_n808 <= setup_light_unit_z_n807 & setup_light_unit_z_n788;
    setup_light_unit_z_n809 <= setup_light_unit_z_n808 & setup_light_unit_z_n789;
    setup_light_unit_z_n810 <= setup_light_unit_z_n809 & setup_light_unit_z_n790;
    setup_light_unit_z_n811 <= setup_light_unit_z_n810 & setup_light_unit_z_n791;
    setup_light_unit_z_n812 <= setup_light_unit_z_n811 & setup_light_unit_z_n792;
    setup_light_unit_z_n813 <= setup_light_unit_z_n812 & setup_light_unit_z_n793;
    setup_light_unit_z_n814 <= setup_light_unit_z_n813 & setup_light_unit_z_n794;
    setup_light_unit_z_n815 <= setup_light_unit_z_n814 & setup_light_unit_z_n795;
    setup_light_unit_z_n816 <= setup_light_unit_z_n815 & setup_light_unit_z_n796;
    setup_light_unit_z_n819 <= setup_light_unit_x_n388 & setup_light_unit_z_n816;
    setup_light_unit_z_n820 <= setup_light_unit_z_n819(22 downto 0);
    setup_light_unit_z_n821 <= signed(resize(setup_light_unit_z_n820, 24));
    setup_light_unit_z_n822 <= unsigned(setup_light_unit_z_n821);
    setup_light_unit_z_n823 <= setup_light_unit_z_n775(1 downto 1);
    setup_light_unit_z_n824 <= setup_light_unit_z_n822 & setup_light_unit_z_n823;
    setup_light_unit_z_n825 <= signed(setup_light_unit_z_n824);
    setup_light_unit_z_n831 <= setup_light_unit_z_n775(0 downto 0);
    setup_light_unit_z_n983 <= "1" when setup_light_unit_z_n775 = shift_left(resize(setup_light_length_n43, 23), 18) else "0";
    setup_light_unit_z_n985 <= unsigned(setup_light_frame_z(22 downto 22));
    -- setup.half
    setup_half_frame_x_sum <= resize(setup_half_n993_s2, 39) + 39x"0000002000";
    setup_half_frame_x_cut <= setup_half_frame_x_sum(38 downto 14);
    setup_half_frame_x_over <= "1" when setup_half_frame_x_cut(24) = '0' and (or setup_half_frame_x_cut(23 downto 22)) = '1' else "0";
    setup_half_frame_x_under <= "1" when setup_half_frame_x_cut(24) = '1' and (and setup_half_frame_x_cut(23 downto 22)) = '0' else "0";
    setup_half_frame_x <= 23x"3fffff" when setup_half_frame_x_over(0) = '1' else 23x"400000" when setup_half_frame_x_under(0) = '1' else setup_half_frame_x_cut(22 downto 0);
    setup_half_frame_y_sum <= resize(setup_half_n999_s2, 39) + 39x"0000002000";
    setup_half_frame_y_cut <= setup_half_frame_y_sum(38 downto 14);
    setup_half_frame_y_over <= "1" when setup_half_frame_y_cut(24) = '0' and (or setup_half_frame_y_cut(23 downto 22)) = '1' else "0";
    setup_half_frame_y_under <= "1" when setup_half_frame_y_cut(24) = '1' and (and setup_half_frame_y_cut(23 downto 22)) = '0' else "0";
    setup_half_frame_y <= 23x"3fffff" when setup_half_frame_y_over(0) = '1' else 23x"400000" when setup_half_frame_y_under(0) = '1' else setup_half_frame_y_cut(22 downto 0);
    setup_half_frame_z_sum <= resize(setup_half_n1005_s2, 39) + 39x"0000002000";
    setup_half_frame_z_cut <= setup_half_frame_z_sum(38 downto 14);
    setup_half_frame_z_over <= "1" when setup_half_frame_z_cut(24) = '0' and (or setup_half_frame_z_cut(23 downto 22)) = '1' else "0";
    setup_half_frame_z_under <= "1" when setup_half_frame_z_cut(24) = '1' and (and setup_half_frame_z_cut(23 downto 22)) = '0' else "0";
    setup_half_frame_z <= 23x"3fffff" when setup_half_frame_z_over(0) = '1' else 23x"400000" when setup_half_frame_z_under(0) = '1' else setup_half_frame_z_cut(22 downto 0);
    -- setup.half.unit_x
    setup_half_unit_x_n1310_neg <= unsigned(-setup_half_frame_x);
    setup_half_unit_x_n1310 <= setup_half_unit_x_n1310_neg when setup_half_frame_x(22) = '1' else unsigned(setup_half_frame_x);
    setup_half_unit_x_n1312 <= setup_half_unit_x_n1310(22 downto 22);
    setup_half_unit_x_n1313 <= setup_half_unit_x_n1310(21 downto 21);
    setup_half_unit_x_n1314 <= setup_half_unit_x_n1310(20 downto 20);
    setup_half_unit_x_n1315 <= setup_half_unit_x_n1310(19 downto 19);
    setup_half_unit_x_n1316 <= setup_half_unit_x_n1310(18 downto 18);
    setup_half_unit_x_n1317 <= setup_half_unit_x_n1310(17 downto 17);
    setup_half_unit_x_n1318 <= setup_half_unit_x_n1310(16 downto 16);
    setup_half_unit_x_n1319 <= setup_half_unit_x_n1310(15 downto 15);
    setup_half_unit_x_n1320 <= setup_half_unit_x_n1310(14 downto 14);
    setup_half_unit_x_n1321 <= setup_half_unit_x_n1310(13 downto 13);
    setup_half_unit_x_n1322 <= setup_half_unit_x_n1310(12 downto 12);
    setup_half_unit_x_n1323 <= setup_half_unit_x_n1310(11 downto 11);
    setup_half_unit_x_n1324 <= setup_half_unit_x_n1310(10 downto 10);
    setup_half_unit_x_n1325 <= setup_half_unit_x_n1310(9 downto 9);
    setup_half_unit_x_n1326 <= setup_half_unit_x_n1310(8 downto 8);
    setup_half_unit_x_n1327 <= setup_half_unit_x_n1310(7 downto 7);
    setup_half_unit_x_n1328 <= setup_half_unit_x_n1310(6 downto 6);
    setup_half_unit_x_n1329 <= setup_half_unit_x_n1310(5 downto 5);
    setup_half_unit_x_n1330 <= setup_half_unit_x_n1310(4 downto 4);
    setup_half_unit_x_n1331 <= setup_half_unit_x_n1310(3 downto 3);
    setup_half_unit_x_n1332 <= setup_half_unit_x_n1310(2 downto 2);
    setup_half_unit_x_n1333 <= setup_half_unit_x_n1312 & setup_half_unit_x_n1313;
    setup_half_unit_x_n1334 <= setup_half_unit_x_n1333 & setup_half_unit_x_n1314;
    setup_half_unit_x_n1335 <= setup_half_unit_x_n1334 & setup_half_unit_x_n1315;
    setup_half_unit_x_n1336 <= setup_half_unit_x_n1335 & setup_half_unit_x_n1316;
    setup_half_unit_x_n1337 <= setup_half_unit_x_n1336 & setup_half_unit_x_n1317;
    setup_half_unit_x_n1338 <= setup_half_unit_x_n1337 & setup_half_unit_x_n1318;
    setup_half_unit_x_n1339 <= setup_half_unit_x_n1338 & setup_half_unit_x_n1319;
    setup_half_unit_x_n1340 <= setup_half_unit_x_n1339 & setup_half_unit_x_n1320;
    setup_half_unit_x_n1341 <= setup_half_unit_x_n1340 & setup_half_unit_x_n1321;
    setup_half_unit_x_n1342 <= setup_half_unit_x_n1341 & setup_half_unit_x_n1322;
    setup_half_unit_x_n1343 <= setup_half_unit_x_n1342 & setup_half_unit_x_n1323;
    setup_half_unit_x_n1344 <= setup_half_unit_x_n1343 & setup_half_unit_x_n1324;
    setup_half_unit_x_n1345 <= setup_half_unit_x_n1344 & setup_half_unit_x_n1325;
    setup_half_unit_x_n1346 <= setup_half_unit_x_n1345 & setup_half_unit_x_n1326;
    setup_half_unit_x_n1347 <= setup_half_unit_x_n1346 & setup_half_unit_x_n1327;
    setup_half_unit_x_n1348 <= setup_half_unit_x_n1347 & setup_half_unit_x_n1328;
    setup_half_unit_x_n1349 <= setup_half_unit_x_n1348 & setup_half_unit_x_n1329;
    setup_half_unit_x_n1350 <= setup_half_unit_x_n1349 & setup_half_unit_x_n1330;
    setup_half_unit_x_n1351 <= setup_half_unit_x_n1350 & setup_half_unit_x_n1331;
    setup_half_unit_x_n1352 <= setup_half_unit_x_n1351 & setup_half_unit_x_n1332;
    setup_half_unit_x_n1355 <= setup_light_unit_x_n388 & setup_half_unit_x_n1352;
    setup_half_unit_x_n1356 <= setup_half_unit_x_n1355(22 downto 0);
    setup_half_unit_x_n1357 <= signed(resize(setup_half_unit_x_n1356, 24));
    setup_half_unit_x_n1358 <= unsigned(setup_half_unit_x_n1357);
    setup_half_unit_x_n1359 <= setup_half_unit_x_n1310(1 downto 1);
    setup_half_unit_x_n1360 <= setup_half_unit_x_n1358 & setup_half_unit_x_n1359;
    setup_half_unit_x_n1361 <= signed(setup_half_unit_x_n1360);
    setup_half_unit_x_n1367 <= setup_half_unit_x_n1310(0 downto 0);
    setup_half_unit_x_n1520 <= "1" when setup_half_unit_x_n1310 = shift_left(resize(setup_light_length_n43, 23), 18) else "0";
    setup_half_unit_x_n1522 <= unsigned(setup_half_frame_x(22 downto 22));
    -- setup.half.unit_y
    setup_half_unit_y_n1526_neg <= unsigned(-setup_half_frame_y);
    setup_half_unit_y_n1526 <= setup_half_unit_y_n1526_neg when setup_half_frame_y(22) = '1' else unsigned(setup_half_frame_y);
    setup_half_unit_y_n1527 <= setup_half_unit_y_n1526(22 downto 22);
    setup_half_unit_y_n1528 <= setup_half_unit_y_n1526(21 downto 21);
    setup_half_unit_y_n1529 <= setup_half_unit_y_n1526(20 downto 20);
    setup_half_unit_y_n1530 <= setup_half_unit_y_n1526(19 downto 19);
    setup_half_unit_y_n1531 <= setup_half_unit_y_n1526(18 downto 18);
    setup_half_unit_y_n1532 <= setup_half_unit_y_n1526(17 downto 17);
    setup_half_unit_y_n1533 <= setup_half_unit_y_n1526(16 downto 16);
    setup_half_unit_y_n1534 <= setup_half_unit_y_n1526(15 downto 15);
    setup_half_unit_y_n1535 <= setup_half_unit_y_n1526(14 downto 14);
    setup_half_unit_y_n1536 <= setup_half_unit_y_n1526(13 downto 13);
    setup_half_unit_y_n1537 <= setup_half_unit_y_n1526(12 downto 12);
    setup_half_unit_y_n1538 <= setup_half_unit_y_n1526(11 downto 11);
    setup_half_unit_y_n1539 <= setup_half_unit_y_n1526(10 downto 10);
    setup_half_unit_y_n1540 <= setup_half_unit_y_n1526(9 downto 9);
    setup_half_unit_y_n1541 <= setup_half_unit_y_n1526(8 downto 8);
    setup_half_unit_y_n1542 <= setup_half_unit_y_n1526(7 downto 7);
    setup_half_unit_y_n1543 <= setup_half_unit_y_n1526(6 downto 6);
    setup_half_unit_y_n1544 <= setup_half_unit_y_n1526(5 downto 5);
    setup_half_unit_y_n1545 <= setup_half_unit_y_n1526(4 downto 4);
    setup_half_unit_y_n1546 <= setup_half_unit_y_n1526(3 downto 3);
    setup_half_unit_y_n1547 <= setup_half_unit_y_n1526(2 downto 2);
    setup_half_unit_y_n1548 <= setup_half_unit_y_n1527 & setup_half_unit_y_n1528;
    setup_half_unit_y_n1549 <= setup_half_unit_y_n1548 & setup_half_unit_y_n1529;
    setup_half_unit_y_n1550 <= setup_half_unit_y_n1549 & setup_half_unit_y_n1530;
    setup_half_unit_y_n1551 <= setup_half_unit_y_n1550 & setup_half_unit_y_n1531;
    setup_half_unit_y_n1552 <= setup_half_unit_y_n1551 & setup_half_unit_y_n1532;
    setup_half_unit_y_n1553 <= setup_half_unit_y_n1552 & setup_half_unit_y_n1533;
    setup_half_unit_y_n1554 <= setup_half_unit_y_n1553 & setup_half_unit_y_n1534;
    setup_half_unit_y_n1555 <= setup_half_unit_y_n1554 & setup_half_unit_y_n1535;
    setup_half_unit_y_n1556 <= setup_half_unit_y_n1555 & setup_half_unit_y_n1536;
    setup_half_unit_y_n1557 <= setup_half_unit_y_n1556 & setup_half_unit_y_n1537;
    setup_half_unit_y_n1558 <= setup_half_unit_y_n1557 & setup_half_unit_y_n1538;
    setup_half_unit_y_n1559 <= setup_half_unit_y_n1558 & setup_half_unit_y_n1539;
    setup_half_unit_y_n1560 <= setup_half_unit_y_n1559 & setup_half_unit_y_n1540;
    setup_half_unit_y_n1561 <= setup_half_unit_y_n1560 & setup_half_unit_y_n1541;
    setup_half_unit_y_n1562 <= setup_half_unit_y_n1561 & setup_half_unit_y_n1542;
    setup_half_unit_y_n1563 <= setup_half_unit_y_n1562 & setup_half_unit_y_n1543;
    setup_half_unit_y_n1564 <= setup_half_unit_y_n1563 & setup_half_unit_y_n1544;
    setup_half_unit_y_n1565 <= setup_half_unit_y_n1564 & setup_half_unit_y_n1545;
    setup_half_unit_y_n1566 <= setup_half_unit_y_n1565 & setup_half_unit_y_n1546;
    setup_half_unit_y_n1567 <= setup_half_unit_y_n1566 & setup_half_unit_y_n1547;
    setup_half_unit_y_n1570 <= setup_light_unit_x_n388 & setup_half_unit_y_n1567;
    setup_half_unit_y_n1571 <= setup_half_unit_y_n1570(22 downto 0);
    setup_half_unit_y_n1572 <= signed(resize(setup_half_unit_y_n1571, 24));
    setup_half_unit_y_n1573 <= unsigned(setup_half_unit_y_n1572);
    setup_half_unit_y_n1574 <= setup_half_unit_y_n1526(1 downto 1);
    setup_half_unit_y_n1575 <= setup_half_unit_y_n1573 & setup_half_unit_y_n1574;
    setup_half_unit_y_n1576 <= signed(setup_half_unit_y_n1575);
    setup_half_unit_y_n1582 <= setup_half_unit_y_n1526(0 downto 0);
    setup_half_unit_y_n1734 <= "1" when setup_half_unit_y_n1526 = shift_left(resize(setup_light_length_n43, 23), 18) else "0";
    setup_half_unit_y_n1736 <= unsigned(setup_half_frame_y(22 downto 22));
    -- setup.half.unit_z
    setup_half_unit_z_n1740_neg <= unsigned(-setup_half_frame_z);
    setup_half_unit_z_n1740 <= setup_half_unit_z_n1740_neg when setup_half_frame_z(22) = '1' else unsigned(setup_half_frame_z);
    setup_half_unit_z_n1741 <= setup_half_unit_z_n1740(22 downto 22);
    setup_half_unit_z_n1742 <= setup_half_unit_z_n1740(21 downto 21);
    setup_half_unit_z_n1743 <= setup_half_unit_z_n1740(20 downto 20);
    setup_half_unit_z_n1744 <= setup_half_unit_z_n1740(19 downto 19);
    setup_half_unit_z_n1745 <= setup_half_unit_z_n1740(18 downto 18);
    setup_half_unit_z_n1746 <= setup_half_unit_z_n1740(17 downto 17);
    setup_half_unit_z_n1747 <= setup_half_unit_z_n1740(16 downto 16);
    setup_half_unit_z_n1748 <= setup_half_unit_z_n1740(15 downto 15);
    setup_half_unit_z_n1749 <= setup_half_unit_z_n1740(14 downto 14);
    setup_half_unit_z_n1750 <= setup_half_unit_z_n1740(13 downto 13);
    setup_half_unit_z_n1751 <= setup_half_unit_z_n1740(12 downto 12);
    setup_half_unit_z_n1752 <= setup_half_unit_z_n1740(11 downto 11);
    setup_half_unit_z_n1753 <= setup_half_unit_z_n1740(10 downto 10);
    setup_half_unit_z_n1754 <= setup_half_unit_z_n1740(9 downto 9);
    setup_half_unit_z_n1755 <= setup_half_unit_z_n1740(8 downto 8);
    setup_half_unit_z_n1756 <= setup_half_unit_z_n1740(7 downto 7);
    setup_half_unit_z_n1757 <= setup_half_unit_z_n1740(6 downto 6);
    setup_half_unit_z_n1758 <= setup_half_unit_z_n1740(5 downto 5);
    setup_half_unit_z_n1759 <= setup_half_unit_z_n1740(4 downto 4);
    setup_half_unit_z_n1760 <= setup_half_unit_z_n1740(3 downto 3);
    setup_half_unit_z_n1761 <= setup_half_unit_z_n1740(2 downto 2);
    setup_half_unit_z_n1762 <= setup_half_unit_z_n1741 & setup_half_unit_z_n1742;
    setup_half_unit_z_n1763 <= setup_half_unit_z_n1762 & setup_half_unit_z_n1743;
    setup_half_unit_z_n1764 <= setup_half_unit_z_n1763 & setup_half_unit_z_n1744;
    setup_half_unit_z_n1765 <= setup_half_unit_z_n1764 & setup_half_unit_z_n1745;
    setup_half_unit_z_n1766 <= setup_half_unit_z_n1765 & setup_half_unit_z_n1746;
    setup_half_unit_z_n1767 <= setup_half_unit_z_n1766 & setup_half_unit_z_n1747;
    setup_half_unit_z_n1768 <= setup_half_unit_z_n1767 & setup_half_unit_z_n1748;
    setup_half_unit_z_n1769 <= setup_half_unit_z_n1768 & setup_half_unit_z_n1749;
    setup_half_unit_z_n1770 <= setup_half_unit_z_n1769 & setup_half_unit_z_n1750;
    setup_half_unit_z_n1771 <= setup_half_unit_z_n1770 & setup_half_unit_z_n1751;
    setup_half_unit_z_n1772 <= setup_half_unit_z_n1771 & setup_half_unit_z_n1752;
    setup_half_unit_z_n1773 <= setup_half_unit_z_n1772 & setup_half_unit_z_n1753;
    setup_half_unit_z_n1774 <= setup_half_unit_z_n1773 & setup_half_unit_z_n1754;
    setup_half_unit_z_n1775 <= setup_half_unit_z_n1774 & setup_half_unit_z_n1755;
    setup_half_unit_z_n1776 <= setup_half_unit_z_n1775 & setup_half_unit_z_n1756;
    setup_half_unit_z_n1777 <= setup_half_unit_z_n1776 & setup_half_unit_z_n1757;
    setup_half_unit_z_n1778 <= setup_half_unit_z_n1777 & setup_half_unit_z_n1758;
    setup_half_unit_z_n1779 <= setup_half_unit_z_n1778 & setup_half_unit_z_n1759;
    setup_half_unit_z_n1780 <= setup_half_unit_z_n1779 & setup_half_unit_z_n1760;
    setup_half_unit_z_n1781 <= setup_half_unit_z_n1780 & setup_half_unit_z_n1761;
    setup_half_unit_z_n1784 <= setup_light_unit_x_n388 & setup_half_unit_z_n1781;
    setup_half_unit_z_n1785 <= setup_half_unit_z_n1784(22 downto 0);
    setup_half_unit_z_n1786 <= signed(resize(setup_half_unit_z_n1785, 24));
    setup_half_unit_z_n1787 <= unsigned(setup_half_unit_z_n1786);
    setup_half_unit_z_n1788 <= setup_half_unit_z_n1740(1 downto 1);
    setup_half_unit_z_n1789 <= setup_half_unit_z_n1787 & setup_half_unit_z_n1788;
    setup_half_unit_z_n1790 <= signed(setup_half_unit_z_n1789);
    setup_half_unit_z_n1796 <= setup_half_unit_z_n1740(0 downto 0);
    setup_half_unit_z_n1948 <= "1" when setup_half_unit_z_n1740 = shift_left(resize(setup_light_length_n43, 23), 18) else "0";
    setup_half_unit_z_n1950 <= unsigned(setup_half_frame_z(22 downto 22));
    -- setup.bump.length
    setup_bump_length_n1964 <= signed(resize(setup_bump_length_n1961_s2, 3)) when setup_bump_length_n1963_s2(0) = '1' else setup_bump_length_n1962_s2;
    setup_bump_length_n1965 <= unsigned(setup_bump_length_n1964(1 downto 0));
    setup_bump_length_n1966 <= setup_bump_length_n1963_s2 xor setup_light_length_n42;
    setup_bump_length_n1970 <= setup_bump_length_n1965 & setup_bump_length_n1969_s2;
    setup_bump_length_n1971 <= setup_bump_length_n1966 & setup_light_length_n43;
    setup_bump_length_n1972 <= setup_bump_length_n1971 & setup_light_length_n42;
    setup_bump_length_n1973 <= signed(resize(setup_bump_length_n1970, 5)) - signed(resize(setup_bump_length_n1972, 5));
    setup_bump_length_n1974 <= unsigned(setup_bump_length_n1973(4 downto 4));
    setup_bump_length_n1975 <= signed(resize(setup_bump_length_n1970, 5)) when setup_bump_length_n1974(0) = '1' else setup_bump_length_n1973;
    setup_bump_length_n1976 <= unsigned(setup_bump_length_n1975(2 downto 0));
    setup_bump_length_n1977 <= setup_bump_length_n1974 xor setup_light_length_n42;
    setup_bump_length_n1978 <= setup_bump_length_n1966 & setup_bump_length_n1977;
    setup_bump_length_n1982 <= setup_bump_length_n1976 & setup_bump_length_n1981_s2;
    setup_bump_length_n1983 <= setup_bump_length_n1978 & setup_light_length_n43;
    setup_bump_length_n1984 <= setup_bump_length_n1983 & setup_light_length_n42;
    setup_bump_length_n1985 <= signed(resize(setup_bump_length_n1982, 6)) - signed(resize(setup_bump_length_n1984, 6));
    setup_bump_length_n1986 <= unsigned(setup_bump_length_n1985(5 downto 5));
    setup_bump_length_n1987 <= signed(resize(setup_bump_length_n1982, 6)) when setup_bump_length_n1986(0) = '1' else setup_bump_length_n1985;
    setup_bump_length_n1988 <= unsigned(setup_bump_length_n1987(3 downto 0));
    setup_bump_length_n1989 <= setup_bump_length_n1986 xor setup_light_length_n42;
    setup_bump_length_n1990 <= setup_bump_length_n1978 & setup_bump_length_n1989;
    setup_bump_length_n1994 <= setup_bump_length_n1988 & setup_bump_length_n1993_s2;
    setup_bump_length_n1995 <= setup_bump_length_n1990 & setup_light_length_n43;
    setup_bump_length_n1996 <= setup_bump_length_n1995 & setup_light_length_n42;
    setup_bump_length_n1997 <= signed(resize(setup_bump_length_n1994, 7)) - signed(resize(setup_bump_length_n1996, 7));
    setup_bump_length_n1998 <= unsigned(setup_bump_length_n1997(6 downto 6));
    setup_bump_length_n1999 <= signed(resize(setup_bump_length_n1994, 7)) when setup_bump_length_n1998(0) = '1' else setup_bump_length_n1997;
    setup_bump_length_n2000 <= unsigned(setup_bump_length_n1999(4 downto 0));
    setup_bump_length_n2001 <= setup_bump_length_n1998 xor setup_light_length_n42;
    setup_bump_length_n2002 <= setup_bump_length_n1990 & setup_bump_length_n2001;
    setup_bump_length_n2006 <= setup_bump_length_n2000 & setup_bump_length_n2005_s2;
    setup_bump_length_n2007 <= setup_bump_length_n2002 & setup_light_length_n43;
    setup_bump_length_n2008 <= setup_bump_length_n2007 & setup_light_length_n42;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_frame_x_s3 <= setup_light_frame_x;
                setup_light_frame_y_s3 <= setup_light_frame_y;
                setup_light_frame_z_s3 <= setup_light_frame_z;
                setup_light_length_n327_s3 <= setup_light_length_n327_s2;
                setup_light_unit_x_n385_s3 <= setup_light_unit_x_n385;
                setup_light_unit_x_n395_s3 <= setup_light_unit_x_n395;
                setup_light_unit_x_n396_s3 <= setup_light_unit_x_n396_s2;
                setup_light_unit_x_n402_s3 <= setup_light_unit_x_n402;
                setup_light_unit_x_n555_s3 <= setup_light_unit_x_n555;
                setup_light_unit_x_n557_s3 <= setup_light_unit_x_n557;
                setup_light_unit_y_n602_s3 <= setup_light_unit_y_n602;
                setup_light_unit_y_n611_s3 <= setup_light_unit_y_n611;
                setup_light_unit_y_n617_s3 <= setup_light_unit_y_n617;
                setup_light_unit_y_n769_s3 <= setup_light_unit_y_n769;
                setup_light_unit_y_n771_s3 <= setup_light_unit_y_n771;
                setup_light_unit_z_n816_s3 <= setup_light_unit_z_n816;
                setup_light_unit_z_n825_s3 <= setup_light_unit_z_n825;
                setup_light_unit_z_n831_s3 <= setup_light_unit_z_n831;
                setup_light_unit_z_n983_s3 <= setup_light_unit_z_n983;
                setup_light_unit_z_n985_s3 <= setup_light_unit_z_n985;
                setup_half_frame_x_s3 <= setup_half_frame_x;
                setup_half_frame_y_s3 <= setup_half_frame_y;
                setup_half_frame_z_s3 <= setup_half_frame_z;
                setup_half_unit_x_n1352_s3 <= setup_half_unit_x_n1352;
                setup_half_unit_x_n1361_s3 <= setup_half_unit_x_n1361;
                setup_half_unit_x_n1367_s3 <= setup_half_unit_x_n1367;
                setup_half_unit_x_n1520_s3 <= setup_half_unit_x_n1520;
                setup_half_unit_x_n1522_s3 <= setup_half_unit_x_n1522;
                setup_half_unit_y_n1567_s3 <= setup_half_unit_y_n1567;
                setup_half_unit_y_n1576_s3 <= setup_half_unit_y_n1576;
                setup_half_unit_y_n1582_s3 <= setup_half_unit_y_n1582;
                setup_half_unit_y_n1734_s3 <= setup_half_unit_y_n1734;
                setup_half_unit_y_n1736_s3 <= setup_half_unit_y_n1736;
                setup_half_unit_z_n1781_s3 <= setup_half_unit_z_n1781;
                setup_half_unit_z_n1790_s3 <= setup_half_unit_z_n1790;
                setup_half_unit_z_n1796_s3 <= setup_half_unit_z_n1796;
                setup_half_unit_z_n1948_s3 <= setup_half_unit_z_n1948;
                setup_half_unit_z_n1950_s3 <= setup_half_unit_z_n1950;
                setup_bump_length_n2002_s3 <= setup_bump_length_n2002;
                setup_bump_length_n2006_s3 <= setup_bump_length_n2006;
                setup_bump_length_n2008_s3 <= setup_bump_length_n2008;
                setup_bump_length_n2017_s3 <= setup_bump_length_n2017_s2;
                setup_bump_length_n2029_s3 <= setup_bump_length_n2029_s2;
                setup_bump_length_n2041_s3 <= setup_bump_length_n2041_s2;
                setup_bump_length_n2053_s3 <= setup_bump_length_n2053_s2;
                setup_bump_length_n2065_s3 <= setup_bump_length_n2065_s2;
                setup_bump_length_n2077_s3 <= setup_bump_length_n2077_s2;
                setup_bump_length_n2089_s3 <= setup_bump_length_n2089_s2;
                setup_bump_length_n2101_s3 <= setup_bump_length_n2101_s2;
                setup_bump_length_n2113_s3 <= setup_bump_length_n2113_s2;
                setup_bump_length_n2125_s3 <= setup_bump_length_n2125_s2;
                setup_bump_length_n2137_s3 <= setup_bump_length_n2137_s2;
                setup_bump_length_n2149_s3 <= setup_bump_length_n2149_s2;
                setup_bump_length_n2161_s3 <= setup_bump_length_n2161_s2;
                setup_bump_length_n2173_s3 <= setup_bump_length_n2173_s2;
                setup_bump_unit_x_n2251_s3 <= setup_bump_unit_x_n2251_s2;
                setup_bump_unit_x_n2259_s3 <= setup_bump_unit_x_n2259_s2;
                setup_bump_unit_x_n2417_s3 <= setup_bump_unit_x_n2417_s2;
                setup_bump_unit_x_n2419_s3 <= setup_bump_unit_x_n2419_s2;
                setup_bump_unit_y_n2458_s3 <= setup_bump_unit_y_n2458_s2;
                setup_bump_unit_y_n2466_s3 <= setup_bump_unit_y_n2466_s2;
                setup_bump_unit_y_n2623_s3 <= setup_bump_unit_y_n2623_s2;
                setup_bump_unit_y_n2625_s3 <= setup_bump_unit_y_n2625_s2;
                setup_bump_unit_z_n2664_s3 <= setup_bump_unit_z_n2664_s2;
                setup_bump_unit_z_n2672_s3 <= setup_bump_unit_z_n2672_s2;
                setup_bump_unit_z_n2829_s3 <= setup_bump_unit_z_n2829_s2;
                setup_bump_unit_z_n2831_s3 <= setup_bump_unit_z_n2831_s2;
            end if;
            if rst = '1' then
                valid_s3 <= '0';
            elsif ce = '1' then
                valid_s3 <= valid_s2;
            end if;
        end if;
    end process;

    -- ---- stage 3 ----
    -- setup.light
    setup_light_n36 <= setup_light_frame_x_s3 * setup_light_frame_x_s3;
    setup_light_n37 <= setup_light_frame_y_s3 * setup_light_frame_y_s3;
    setup_light_n38 <= setup_light_frame_z_s3 * setup_light_frame_z_s3;
    -- setup.half
    setup_half_n1007 <= setup_half_frame_x_s3 * setup_half_frame_x_s3;
    setup_half_n1008 <= setup_half_frame_y_s3 * setup_half_frame_y_s3;
    setup_half_n1009 <= setup_half_frame_z_s3 * setup_half_frame_z_s3;
    -- setup.bump.length
    setup_bump_length_n2009 <= signed(resize(setup_bump_length_n2006_s3, 8)) - signed(resize(setup_bump_length_n2008_s3, 8));
    setup_bump_length_n2010 <= unsigned(setup_bump_length_n2009(7 downto 7));
    setup_bump_length_n2011 <= signed(resize(setup_bump_length_n2006_s3, 8)) when setup_bump_length_n2010(0) = '1' else setup_bump_length_n2009;
    setup_bump_length_n2012 <= unsigned(setup_bump_length_n2011(5 downto 0));
    setup_bump_length_n2013 <= setup_bump_length_n2010 xor setup_light_length_n42;
    setup_bump_length_n2014 <= setup_bump_length_n2002_s3 & setup_bump_length_n2013;
    setup_bump_length_n2018 <= setup_bump_length_n2012 & setup_bump_length_n2017_s3;
    setup_bump_length_n2019 <= setup_bump_length_n2014 & setup_light_length_n43;
    setup_bump_length_n2020 <= setup_bump_length_n2019 & setup_light_length_n42;
    setup_bump_length_n2021 <= signed(resize(setup_bump_length_n2018, 9)) - signed(resize(setup_bump_length_n2020, 9));
    setup_bump_length_n2022 <= unsigned(setup_bump_length_n2021(8 downto 8));
    setup_bump_length_n2023 <= signed(resize(setup_bump_length_n2018, 9)) when setup_bump_length_n2022(0) = '1' else setup_bump_length_n2021;
    setup_bump_length_n2024 <= unsigned(setup_bump_length_n2023(6 downto 0));
    setup_bump_length_n2025 <= setup_bump_length_n2022 xor setup_light_length_n42;
    setup_bump_length_n2026 <= setup_bump_length_n2014 & setup_bump_length_n2025;
    setup_bump_length_n2030 <= setup_bump_length_n2024 & setup_bump_length_n2029_s3;
    setup_bump_length_n2031 <= setup_bump_length_n2026 & setup_light_length_n43;
    setup_bump_length_n2032 <= setup_bump_length_n2031 & setup_light_length_n42;
    setup_bump_length_n2033 <= signed(resize(setup_bump_length_n2030, 10)) - signed(resize(setup_bump_length_n2032, 10));
    setup_bump_length_n2034 <= unsigned(setup_bump_length_n2033(9 downto 9));
    setup_bump_length_n2035 <= signed(resize(setup_bump_length_n2030, 10)) when setup_bump_length_n2034(0) = '1' else setup_bump_length_n2033;
    setup_bump_length_n2036 <= unsigned(setup_bump_length_n2035(7 downto 0));
    setup_bump_length_n2037 <= setup_bump_length_n2034 xor setup_light_length_n42;
    setup_bump_length_n2038 <= setup_bump_length_n2026 & setup_bump_length_n2037;
    setup_bump_length_n2042 <= setup_bump_length_n2036 & setup_bump_length_n2041_s3;
    setup_bump_length_n2043 <= setup_bump_length_n2038 & setup_light_length_n43;
    setup_bump_length_n2044 <= setup_bump_length_n2043 & setup_light_length_n42;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_n36_s4 <= setup_light_n36;
                setup_light_n37_s4 <= setup_light_n37;
                setup_light_n38_s4 <= setup_light_n38;
                setup_light_length_n327_s4 <= setup_light_length_n327_s3;
                setup_light_unit_x_n385_s4 <= setup_light_unit_x_n385_s3;
                setup_light_unit_x_n395_s4 <= setup_light_unit_x_n395_s3;
                setup_light_unit_x_n396_s4 <= setup_light_unit_x_n396_s3;
                setup_light_unit_x_n402_s4 <= setup_light_unit_x_n402_s3;
                setup_light_unit_x_n555_s4 <= setup_light_unit_x_n555_s3;
                setup_light_unit_x_n557_s4 <= setup_light_unit_x_n557_s3;
                setup_light_unit_y_n602_s4 <= setup_light_unit_y_n602_s3;
                setup_light_unit_y_n611_s4 <= setup_light_unit_y_n611_s3;
                setup_light_unit_y_n617_s4 <= setup_light_unit_y_n617_s3;
                setup_light_unit_y_n769_s4 <= setup_light_unit_y_n769_s3;
                setup_light_unit_y_n771_s4 <= setup_light_unit_y_n771_s3;
                setup_light_unit_z_n816_s4 <= setup_light_unit_z_n816_s3;
                setup_light_unit_z_n825_s4 <= setup_light_unit_z_n825_s3;
                setup_light_unit_z_n831_s4 <= setup_light_unit_z_n831_s3;
                setup_light_unit_z_n983_s4 <= setup_light_unit_z_n983_s3;
                setup_light_unit_z_n985_s4 <= setup_light_unit_z_n985_s3;
                setup_half_n1007_s4 <= setup_half_n1007;
                setup_half_n1008_s4 <= setup_half_n1008;
                setup_half_n1009_s4 <= setup_half_n1009;
                setup_half_unit_x_n1352_s4 <= setup_half_unit_x_n1352_s3;
                setup_half_unit_x_n1361_s4 <= setup_half_unit_x_n1361_s3;
                setup_half_unit_x_n1367_s4 <= setup_half_unit_x_n1367_s3;
                setup_half_unit_x_n1520_s4 <= setup_half_unit_x_n1520_s3;
                setup_half_unit_x_n1522_s4 <= setup_half_unit_x_n1522_s3;
                setup_half_unit_y_n1567_s4 <= setup_half_unit_y_n1567_s3;
                setup_half_unit_y_n1576_s4 <= setup_half_unit_y_n1576_s3;
                setup_half_unit_y_n1582_s4 <= setup_half_unit_y_n1582_s3;
                setup_half_unit_y_n1734_s4 <= setup_half_unit_y_n1734_s3;
                setup_half_unit_y_n1736_s4 <= setup_half_unit_y_n1736_s3;
                setup_half_unit_z_n1781_s4 <= setup_half_unit_z_n1781_s3;
                setup_half_unit_z_n1790_s4 <= setup_half_unit_z_n1790_s3;
                setup_half_unit_z_n1796_s4 <= setup_half_unit_z_n1796_s3;
                setup_half_unit_z_n1948_s4 <= setup_half_unit_z_n1948_s3;
                setup_half_unit_z_n1950_s4 <= setup_half_unit_z_n1950_s3;
                setup_bump_length_n2038_s4 <= setup_bump_length_n2038;
                setup_bump_length_n2042_s4 <= setup_bump_length_n2042;
                setup_bump_length_n2044_s4 <= setup_bump_length_n2044;
                setup_bump_length_n2053_s4 <= setup_bump_length_n2053_s3;
                setup_bump_length_n2065_s4 <= setup_bump_length_n2065_s3;
                setup_bump_length_n2077_s4 <= setup_bump_length_n2077_s3;
                setup_bump_length_n2089_s4 <= setup_bump_length_n2089_s3;
                setup_bump_length_n2101_s4 <= setup_bump_length_n2101_s3;
                setup_bump_length_n2113_s4 <= setup_bump_length_n2113_s3;
                setup_bump_length_n2125_s4 <= setup_bump_length_n2125_s3;
                setup_bump_length_n2137_s4 <= setup_bump_length_n2137_s3;
                setup_bump_length_n2149_s4 <= setup_bump_length_n2149_s3;
                setup_bump_length_n2161_s4 <= setup_bump_length_n2161_s3;
                setup_bump_length_n2173_s4 <= setup_bump_length_n2173_s3;
                setup_bump_unit_x_n2251_s4 <= setup_bump_unit_x_n2251_s3;
                setup_bump_unit_x_n2259_s4 <= setup_bump_unit_x_n2259_s3;
                setup_bump_unit_x_n2417_s4 <= setup_bump_unit_x_n2417_s3;
                setup_bump_unit_x_n2419_s4 <= setup_bump_unit_x_n2419_s3;
                setup_bump_unit_y_n2458_s4 <= setup_bump_unit_y_n2458_s3;
                setup_bump_unit_y_n2466_s4 <= setup_bump_unit_y_n2466_s3;
                setup_bump_unit_y_n2623_s4 <= setup_bump_unit_y_n2623_s3;
                setup_bump_unit_y_n2625_s4 <= setup_bump_unit_y_n2625_s3;
                setup_bump_unit_z_n2664_s4 <= setup_bump_unit_z_n2664_s3;
                setup_bump_unit_z_n2672_s4 <= setup_bump_unit_z_n2672_s3;
                setup_bump_unit_z_n2829_s4 <= setup_bump_unit_z_n2829_s3;
                setup_bump_unit_z_n2831_s4 <= setup_bump_unit_z_n2831_s3;
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
    setup_light_n39 <= resize(setup_light_n36_s4, 47) + resize(setup_light_n37_s4, 47);
    setup_light_n40 <= resize(setup_light_n39, 48) + resize(setup_light_n38_s4, 48);
    setup_light_square_under <= unsigned(setup_light_n40(47 downto 47));
    setup_light_square <= 47x"000000000000" when setup_light_square_under(0) = '1' else unsigned(setup_light_n40(46 downto 0));
    -- setup.light.length
    setup_light_length_n44 <= setup_light_square(46 downto 46);
    setup_light_length_n45 <= setup_light_length_n43 & setup_light_length_n44;
    setup_light_length_n51 <= setup_light_square(45 downto 45);
    setup_light_length_n52 <= setup_light_square(44 downto 44);
    setup_light_length_n53 <= setup_light_length_n51 & setup_light_length_n52;
    setup_light_length_n63 <= setup_light_square(43 downto 43);
    setup_light_length_n64 <= setup_light_square(42 downto 42);
    setup_light_length_n65 <= setup_light_length_n63 & setup_light_length_n64;
    setup_light_length_n75 <= setup_light_square(41 downto 41);
    setup_light_length_n76 <= setup_light_square(40 downto 40);
    setup_light_length_n77 <= setup_light_length_n75 & setup_light_length_n76;
    setup_light_length_n87 <= setup_light_square(39 downto 39);
    setup_light_length_n88 <= setup_light_square(38 downto 38);
    setup_light_length_n89 <= setup_light_length_n87 & setup_light_length_n88;
    setup_light_length_n99 <= setup_light_square(37 downto 37);
    setup_light_length_n100 <= setup_light_square(36 downto 36);
    setup_light_length_n101 <= setup_light_length_n99 & setup_light_length_n100;
    setup_light_length_n111 <= setup_light_square(35 downto 35);
    setup_light_length_n112 <= setup_light_square(34 downto 34);
    setup_light_length_n113 <= setup_light_length_n111 & setup_light_length_n112;
    setup_light_length_n123 <= setup_light_square(33 downto 33);
    setup_light_length_n124 <= setup_light_square(32 downto 32);
    setup_light_length_n125 <= setup_light_length_n123 & setup_light_length_n124;
    setup_light_length_n135 <= setup_light_square(31 downto 31);
    setup_light_length_n136 <= setup_light_square(30 downto 30);
    setup_light_length_n137 <= setup_light_length_n135 & setup_light_length_n136;
    setup_light_length_n147 <= setup_light_square(29 downto 29);
    setup_light_length_n148 <= setup_light_square(28 downto 28);
    setup_light_length_n149 <= setup_light_length_n147 & setup_light_length_n148;
    setup_light_length_n159 <= setup_light_square(27 downto 27);
    setup_light_length_n160 <= setup_light_square(26 downto 26);
    setup_light_length_n161 <= setup_light_length_n159 & setup_light_length_n160;
    setup_light_length_n171 <= setup_light_square(25 downto 25);
    setup_light_length_n172 <= setup_light_square(24 downto 24);
    setup_light_length_n173 <= setup_light_length_n171 & setup_light_length_n172;
    setup_light_length_n183 <= setup_light_square(23 downto 23);
    setup_light_length_n184 <= setup_light_square(22 downto 22);
    setup_light_length_n185 <= setup_light_length_n183 & setup_light_length_n184;
    setup_light_length_n195 <= setup_light_square(21 downto 21);
    setup_light_length_n196 <= setup_light_square(20 downto 20);
    setup_light_length_n197 <= setup_light_length_n195 & setup_light_length_n196;
    setup_light_length_n207 <= setup_light_square(19 downto 19);
    setup_light_length_n208 <= setup_light_square(18 downto 18);
    setup_light_length_n209 <= setup_light_length_n207 & setup_light_length_n208;
    setup_light_length_n219 <= setup_light_square(17 downto 17);
    setup_light_length_n220 <= setup_light_square(16 downto 16);
    setup_light_length_n221 <= setup_light_length_n219 & setup_light_length_n220;
    setup_light_length_n231 <= setup_light_square(15 downto 15);
    setup_light_length_n232 <= setup_light_square(14 downto 14);
    setup_light_length_n233 <= setup_light_length_n231 & setup_light_length_n232;
    setup_light_length_n243 <= setup_light_square(13 downto 13);
    setup_light_length_n244 <= setup_light_square(12 downto 12);
    setup_light_length_n245 <= setup_light_length_n243 & setup_light_length_n244;
    setup_light_length_n255 <= setup_light_square(11 downto 11);
    setup_light_length_n256 <= setup_light_square(10 downto 10);
    setup_light_length_n257 <= setup_light_length_n255 & setup_light_length_n256;
    setup_light_length_n267 <= setup_light_square(9 downto 9);
    setup_light_length_n268 <= setup_light_square(8 downto 8);
    setup_light_length_n269 <= setup_light_length_n267 & setup_light_length_n268;
    setup_light_length_n279 <= setup_light_square(7 downto 7);
    setup_light_length_n280 <= setup_light_square(6 downto 6);
    setup_light_length_n281 <= setup_light_length_n279 & setup_light_length_n280;
    setup_light_length_n291 <= setup_light_square(5 downto 5);
    setup_light_length_n292 <= setup_light_square(4 downto 4);
    setup_light_length_n293 <= setup_light_length_n291 & setup_light_length_n292;
    setup_light_length_n303 <= setup_light_square(3 downto 3);
    setup_light_length_n304 <= setup_light_square(2 downto 2);
    setup_light_length_n305 <= setup_light_length_n303 & setup_light_length_n304;
    setup_light_length_n315 <= setup_light_square(1 downto 1);
    setup_light_length_n316 <= setup_light_square(0 downto 0);
    setup_light_length_n317 <= setup_light_length_n315 & setup_light_length_n316;
    -- setup.half
    setup_half_n1010 <= resize(setup_half_n1007_s4, 47) + resize(setup_half_n1008_s4, 47);
    setup_half_n1011 <= resize(setup_half_n1010, 48) + resize(setup_half_n1009_s4, 48);
    setup_half_square_under <= unsigned(setup_half_n1011(47 downto 47));
    setup_half_square <= 47x"000000000000" when setup_half_square_under(0) = '1' else unsigned(setup_half_n1011(46 downto 0));
    -- setup.half.length
    setup_half_length_n1013 <= setup_half_square(46 downto 46);
    setup_half_length_n1014 <= setup_light_length_n43 & setup_half_length_n1013;
    setup_half_length_n1020 <= setup_half_square(45 downto 45);
    setup_half_length_n1021 <= setup_half_square(44 downto 44);
    setup_half_length_n1022 <= setup_half_length_n1020 & setup_half_length_n1021;
    setup_half_length_n1032 <= setup_half_square(43 downto 43);
    setup_half_length_n1033 <= setup_half_square(42 downto 42);
    setup_half_length_n1034 <= setup_half_length_n1032 & setup_half_length_n1033;
    setup_half_length_n1044 <= setup_half_square(41 downto 41);
    setup_half_length_n1045 <= setup_half_square(40 downto 40);
    setup_half_length_n1046 <= setup_half_length_n1044 & setup_half_length_n1045;
    setup_half_length_n1056 <= setup_half_square(39 downto 39);
    setup_half_length_n1057 <= setup_half_square(38 downto 38);
    setup_half_length_n1058 <= setup_half_length_n1056 & setup_half_length_n1057;
    setup_half_length_n1068 <= setup_half_square(37 downto 37);
    setup_half_length_n1069 <= setup_half_square(36 downto 36);
    setup_half_length_n1070 <= setup_half_length_n1068 & setup_half_length_n1069;
    setup_half_length_n1080 <= setup_half_square(35 downto 35);
    setup_half_length_n1081 <= setup_half_square(34 downto 34);
    setup_half_length_n1082 <= setup_half_length_n1080 & setup_half_length_n1081;
    setup_half_length_n1092 <= setup_half_square(33 downto 33);
    setup_half_length_n1093 <= setup_half_square(32 downto 32);
    setup_half_length_n1094 <= setup_half_length_n1092 & setup_half_length_n1093;
    setup_half_length_n1104 <= setup_half_square(31 downto 31);
    setup_half_length_n1105 <= setup_half_square(30 downto 30);
    setup_half_length_n1106 <= setup_half_length_n1104 & setup_half_length_n1105;
    setup_half_length_n1116 <= setup_half_square(29 downto 29);
    setup_half_length_n1117 <= setup_half_square(28 downto 28);
    setup_half_length_n1118 <= setup_half_length_n1116 & setup_half_length_n1117;
    setup_half_length_n1128 <= setup_half_square(27 downto 27);
    setup_half_length_n1129 <= setup_half_square(26 downto 26);
    setup_half_length_n1130 <= setup_half_length_n1128 & setup_half_length_n1129;
    setup_half_length_n1140 <= setup_half_square(25 downto 25);
    setup_half_length_n1141 <= setup_half_square(24 downto 24);
    setup_half_length_n1142 <= setup_half_length_n1140 & setup_half_length_n1141;
    setup_half_length_n1152 <= setup_half_square(23 downto 23);
    setup_half_length_n1153 <= setup_half_square(22 downto 22);
    setup_half_length_n1154 <= setup_half_length_n1152 & setup_half_length_n1153;
    setup_half_length_n1164 <= setup_half_square(21 downto 21);
    setup_half_length_n1165 <= setup_half_square(20 downto 20);
    setup_half_length_n1166 <= setup_half_length_n1164 & setup_half_length_n1165;
    setup_half_length_n1176 <= setup_half_square(19 downto 19);
    setup_half_length_n1177 <= setup_half_square(18 downto 18);
    setup_half_length_n1178 <= setup_half_length_n1176 & setup_half_length_n1177;
    setup_half_length_n1188 <= setup_half_square(17 downto 17);
    setup_half_length_n1189 <= setup_half_square(16 downto 16);
    setup_half_length_n1190 <= setup_half_length_n1188 & setup_half_length_n1189;
    setup_half_length_n1200 <= setup_half_square(15 downto 15);
    setup_half_length_n1201 <= setup_half_square(14 downto 14);
    setup_half_length_n1202 <= setup_half_length_n1200 & setup_half_length_n1201;
    setup_half_length_n1212 <= setup_half_square(13 downto 13);
    setup_half_length_n1213 <= setup_half_square(12 downto 12);
    setup_half_length_n1214 <= setup_half_length_n1212 & setup_half_length_n1213;
    setup_half_length_n1224 <= setup_half_square(11 downto 11);
    setup_half_length_n1225 <= setup_half_square(10 downto 10);
    setup_half_length_n1226 <= setup_half_length_n1224 & setup_half_length_n1225;
    setup_half_length_n1236 <= setup_half_square(9 downto 9);
    setup_half_length_n1237 <= setup_half_square(8 downto 8);
    setup_half_length_n1238 <= setup_half_length_n1236 & setup_half_length_n1237;
    setup_half_length_n1248 <= setup_half_square(7 downto 7);
    setup_half_length_n1249 <= setup_half_square(6 downto 6);
    setup_half_length_n1250 <= setup_half_length_n1248 & setup_half_length_n1249;
    setup_half_length_n1260 <= setup_half_square(5 downto 5);
    setup_half_length_n1261 <= setup_half_square(4 downto 4);
    setup_half_length_n1262 <= setup_half_length_n1260 & setup_half_length_n1261;
    setup_half_length_n1272 <= setup_half_square(3 downto 3);
    setup_half_length_n1273 <= setup_half_square(2 downto 2);
    setup_half_length_n1274 <= setup_half_length_n1272 & setup_half_length_n1273;
    setup_half_length_n1284 <= setup_half_square(1 downto 1);
    setup_half_length_n1285 <= setup_half_square(0 downto 0);
    setup_half_length_n1286 <= setup_half_length_n1284 & setup_half_length_n1285;
    -- setup.bump.length
    setup_bump_length_n2045 <= signed(resize(setup_bump_length_n2042_s4, 11)) - signed(resize(setup_bump_length_n2044_s4, 11));
    setup_bump_length_n2046 <= unsigned(setup_bump_length_n2045(10 downto 10));
    setup_bump_length_n2047 <= signed(resize(setup_bump_length_n2042_s4, 11)) when setup_bump_length_n2046(0) = '1' else setup_bump_length_n2045;
    setup_bump_length_n2048 <= unsigned(setup_bump_length_n2047(8 downto 0));
    setup_bump_length_n2049 <= setup_bump_length_n2046 xor setup_light_length_n42;
    setup_bump_length_n2050 <= setup_bump_length_n2038_s4 & setup_bump_length_n2049;
    setup_bump_length_n2054 <= setup_bump_length_n2048 & setup_bump_length_n2053_s4;
    setup_bump_length_n2055 <= setup_bump_length_n2050 & setup_light_length_n43;
    setup_bump_length_n2056 <= setup_bump_length_n2055 & setup_light_length_n42;
    setup_bump_length_n2057 <= signed(resize(setup_bump_length_n2054, 12)) - signed(resize(setup_bump_length_n2056, 12));
    setup_bump_length_n2058 <= unsigned(setup_bump_length_n2057(11 downto 11));
    setup_bump_length_n2059 <= signed(resize(setup_bump_length_n2054, 12)) when setup_bump_length_n2058(0) = '1' else setup_bump_length_n2057;
    setup_bump_length_n2060 <= unsigned(setup_bump_length_n2059(9 downto 0));
    setup_bump_length_n2061 <= setup_bump_length_n2058 xor setup_light_length_n42;
    setup_bump_length_n2062 <= setup_bump_length_n2050 & setup_bump_length_n2061;
    setup_bump_length_n2066 <= setup_bump_length_n2060 & setup_bump_length_n2065_s4;
    setup_bump_length_n2067 <= setup_bump_length_n2062 & setup_light_length_n43;
    setup_bump_length_n2068 <= setup_bump_length_n2067 & setup_light_length_n42;
    setup_bump_length_n2069 <= signed(resize(setup_bump_length_n2066, 13)) - signed(resize(setup_bump_length_n2068, 13));
    setup_bump_length_n2070 <= unsigned(setup_bump_length_n2069(12 downto 12));
    setup_bump_length_n2071 <= signed(resize(setup_bump_length_n2066, 13)) when setup_bump_length_n2070(0) = '1' else setup_bump_length_n2069;
    setup_bump_length_n2072 <= unsigned(setup_bump_length_n2071(10 downto 0));
    setup_bump_length_n2073 <= setup_bump_length_n2070 xor setup_light_length_n42;
    setup_bump_length_n2074 <= setup_bump_length_n2062 & setup_bump_length_n2073;
    setup_bump_length_n2078 <= setup_bump_length_n2072 & setup_bump_length_n2077_s4;
    setup_bump_length_n2079 <= setup_bump_length_n2074 & setup_light_length_n43;
    setup_bump_length_n2080 <= setup_bump_length_n2079 & setup_light_length_n42;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_length_n45_s5 <= setup_light_length_n45;
                setup_light_length_n53_s5 <= setup_light_length_n53;
                setup_light_length_n65_s5 <= setup_light_length_n65;
                setup_light_length_n77_s5 <= setup_light_length_n77;
                setup_light_length_n89_s5 <= setup_light_length_n89;
                setup_light_length_n101_s5 <= setup_light_length_n101;
                setup_light_length_n113_s5 <= setup_light_length_n113;
                setup_light_length_n125_s5 <= setup_light_length_n125;
                setup_light_length_n137_s5 <= setup_light_length_n137;
                setup_light_length_n149_s5 <= setup_light_length_n149;
                setup_light_length_n161_s5 <= setup_light_length_n161;
                setup_light_length_n173_s5 <= setup_light_length_n173;
                setup_light_length_n185_s5 <= setup_light_length_n185;
                setup_light_length_n197_s5 <= setup_light_length_n197;
                setup_light_length_n209_s5 <= setup_light_length_n209;
                setup_light_length_n221_s5 <= setup_light_length_n221;
                setup_light_length_n233_s5 <= setup_light_length_n233;
                setup_light_length_n245_s5 <= setup_light_length_n245;
                setup_light_length_n257_s5 <= setup_light_length_n257;
                setup_light_length_n269_s5 <= setup_light_length_n269;
                setup_light_length_n281_s5 <= setup_light_length_n281;
                setup_light_length_n293_s5 <= setup_light_length_n293;
                setup_light_length_n305_s5 <= setup_light_length_n305;
                setup_light_length_n317_s5 <= setup_light_length_n317;
                setup_light_length_n327_s5 <= setup_light_length_n327_s4;
                setup_light_unit_x_n385_s5 <= setup_light_unit_x_n385_s4;
                setup_light_unit_x_n395_s5 <= setup_light_unit_x_n395_s4;
                setup_light_unit_x_n396_s5 <= setup_light_unit_x_n396_s4;
                setup_light_unit_x_n402_s5 <= setup_light_unit_x_n402_s4;
                setup_light_unit_x_n555_s5 <= setup_light_unit_x_n555_s4;
                setup_light_unit_x_n557_s5 <= setup_light_unit_x_n557_s4;
                setup_light_unit_y_n602_s5 <= setup_light_unit_y_n602_s4;
                setup_light_unit_y_n611_s5 <= setup_light_unit_y_n611_s4;
                setup_light_unit_y_n617_s5 <= setup_light_unit_y_n617_s4;
                setup_light_unit_y_n769_s5 <= setup_light_unit_y_n769_s4;
                setup_light_unit_y_n771_s5 <= setup_light_unit_y_n771_s4;
                setup_light_unit_z_n816_s5 <= setup_light_unit_z_n816_s4;
                setup_light_unit_z_n825_s5 <= setup_light_unit_z_n825_s4;
                setup_light_unit_z_n831_s5 <= setup_light_unit_z_n831_s4;
                setup_light_unit_z_n983_s5 <= setup_light_unit_z_n983_s4;
                setup_light_unit_z_n985_s5 <= setup_light_unit_z_n985_s4;
                setup_half_length_n1014_s5 <= setup_half_length_n1014;
                setup_half_length_n1022_s5 <= setup_half_length_n1022;
                setup_half_length_n1034_s5 <= setup_half_length_n1034;
                setup_half_length_n1046_s5 <= setup_half_length_n1046;
                setup_half_length_n1058_s5 <= setup_half_length_n1058;
                setup_half_length_n1070_s5 <= setup_half_length_n1070;
                setup_half_length_n1082_s5 <= setup_half_length_n1082;
                setup_half_length_n1094_s5 <= setup_half_length_n1094;
                setup_half_length_n1106_s5 <= setup_half_length_n1106;
                setup_half_length_n1118_s5 <= setup_half_length_n1118;
                setup_half_length_n1130_s5 <= setup_half_length_n1130;
                setup_half_length_n1142_s5 <= setup_half_length_n1142;
                setup_half_length_n1154_s5 <= setup_half_length_n1154;
                setup_half_length_n1166_s5 <= setup_half_length_n1166;
                setup_half_length_n1178_s5 <= setup_half_length_n1178;
                setup_half_length_n1190_s5 <= setup_half_length_n1190;
                setup_half_length_n1202_s5 <= setup_half_length_n1202;
                setup_half_length_n1214_s5 <= setup_half_length_n1214;
                setup_half_length_n1226_s5 <= setup_half_length_n1226;
                setup_half_length_n1238_s5 <= setup_half_length_n1238;
                setup_half_length_n1250_s5 <= setup_half_length_n1250;
                setup_half_length_n1262_s5 <= setup_half_length_n1262;
                setup_half_length_n1274_s5 <= setup_half_length_n1274;
                setup_half_length_n1286_s5 <= setup_half_length_n1286;
                setup_half_unit_x_n1352_s5 <= setup_half_unit_x_n1352_s4;
                setup_half_unit_x_n1361_s5 <= setup_half_unit_x_n1361_s4;
                setup_half_unit_x_n1367_s5 <= setup_half_unit_x_n1367_s4;
                setup_half_unit_x_n1520_s5 <= setup_half_unit_x_n1520_s4;
                setup_half_unit_x_n1522_s5 <= setup_half_unit_x_n1522_s4;
                setup_half_unit_y_n1567_s5 <= setup_half_unit_y_n1567_s4;
                setup_half_unit_y_n1576_s5 <= setup_half_unit_y_n1576_s4;
                setup_half_unit_y_n1582_s5 <= setup_half_unit_y_n1582_s4;
                setup_half_unit_y_n1734_s5 <= setup_half_unit_y_n1734_s4;
                setup_half_unit_y_n1736_s5 <= setup_half_unit_y_n1736_s4;
                setup_half_unit_z_n1781_s5 <= setup_half_unit_z_n1781_s4;
                setup_half_unit_z_n1790_s5 <= setup_half_unit_z_n1790_s4;
                setup_half_unit_z_n1796_s5 <= setup_half_unit_z_n1796_s4;
                setup_half_unit_z_n1948_s5 <= setup_half_unit_z_n1948_s4;
                setup_half_unit_z_n1950_s5 <= setup_half_unit_z_n1950_s4;
                setup_bump_length_n2074_s5 <= setup_bump_length_n2074;
                setup_bump_length_n2078_s5 <= setup_bump_length_n2078;
                setup_bump_length_n2080_s5 <= setup_bump_length_n2080;
                setup_bump_length_n2089_s5 <= setup_bump_length_n2089_s4;
                setup_bump_length_n2101_s5 <= setup_bump_length_n2101_s4;
                setup_bump_length_n2113_s5 <= setup_bump_length_n2113_s4;
                setup_bump_length_n2125_s5 <= setup_bump_length_n2125_s4;
                setup_bump_length_n2137_s5 <= setup_bump_length_n2137_s4;
                setup_bump_length_n2149_s5 <= setup_bump_length_n2149_s4;
                setup_bump_length_n2161_s5 <= setup_bump_length_n2161_s4;
                setup_bump_length_n2173_s5 <= setup_bump_length_n2173_s4;
                setup_bump_unit_x_n2251_s5 <= setup_bump_unit_x_n2251_s4;
                setup_bump_unit_x_n2259_s5 <= setup_bump_unit_x_n2259_s4;
                setup_bump_unit_x_n2417_s5 <= setup_bump_unit_x_n2417_s4;
                setup_bump_unit_x_n2419_s5 <= setup_bump_unit_x_n2419_s4;
                setup_bump_unit_y_n2458_s5 <= setup_bump_unit_y_n2458_s4;
                setup_bump_unit_y_n2466_s5 <= setup_bump_unit_y_n2466_s4;
                setup_bump_unit_y_n2623_s5 <= setup_bump_unit_y_n2623_s4;
                setup_bump_unit_y_n2625_s5 <= setup_bump_unit_y_n2625_s4;
                setup_bump_unit_z_n2664_s5 <= setup_bump_unit_z_n2664_s4;
                setup_bump_unit_z_n2672_s5 <= setup_bump_unit_z_n2672_s4;
                setup_bump_unit_z_n2829_s5 <= setup_bump_unit_z_n2829_s4;
                setup_bump_unit_z_n2831_s5 <= setup_bump_unit_z_n2831_s4;
            end if;
            if rst = '1' then
                valid_s5 <= '0';
            elsif ce = '1' then
                valid_s5 <= valid_s4;
            end if;
        end if;
    end process;

    -- ---- stage 5 ----
    -- setup.light.length
    setup_light_length_n46 <= signed(resize(setup_light_length_n45_s5, 3)) - signed(resize(setup_light_length_n42, 3));
    setup_light_length_n47 <= unsigned(setup_light_length_n46(2 downto 2));
    setup_light_length_n48 <= signed(resize(setup_light_length_n45_s5, 3)) when setup_light_length_n47(0) = '1' else setup_light_length_n46;
    setup_light_length_n49 <= unsigned(setup_light_length_n48(1 downto 0));
    setup_light_length_n50 <= setup_light_length_n47 xor setup_light_length_n42;
    setup_light_length_n54 <= setup_light_length_n49 & setup_light_length_n53_s5;
    setup_light_length_n55 <= setup_light_length_n50 & setup_light_length_n43;
    setup_light_length_n56 <= setup_light_length_n55 & setup_light_length_n42;
    setup_light_length_n57 <= signed(resize(setup_light_length_n54, 5)) - signed(resize(setup_light_length_n56, 5));
    setup_light_length_n58 <= unsigned(setup_light_length_n57(4 downto 4));
    setup_light_length_n59 <= signed(resize(setup_light_length_n54, 5)) when setup_light_length_n58(0) = '1' else setup_light_length_n57;
    setup_light_length_n60 <= unsigned(setup_light_length_n59(2 downto 0));
    setup_light_length_n61 <= setup_light_length_n58 xor setup_light_length_n42;
    setup_light_length_n62 <= setup_light_length_n50 & setup_light_length_n61;
    setup_light_length_n66 <= setup_light_length_n60 & setup_light_length_n65_s5;
    setup_light_length_n67 <= setup_light_length_n62 & setup_light_length_n43;
    setup_light_length_n68 <= setup_light_length_n67 & setup_light_length_n42;
    setup_light_length_n69 <= signed(resize(setup_light_length_n66, 6)) - signed(resize(setup_light_length_n68, 6));
    setup_light_length_n70 <= unsigned(setup_light_length_n69(5 downto 5));
    setup_light_length_n71 <= signed(resize(setup_light_length_n66, 6)) when setup_light_length_n70(0) = '1' else setup_light_length_n69;
    setup_light_length_n72 <= unsigned(setup_light_length_n71(3 downto 0));
    setup_light_length_n73 <= setup_light_length_n70 xor setup_light_length_n42;
    setup_light_length_n74 <= setup_light_length_n62 & setup_light_length_n73;
    setup_light_length_n78 <= setup_light_length_n72 & setup_light_length_n77_s5;
    setup_light_length_n79 <= setup_light_length_n74 & setup_light_length_n43;
    setup_light_length_n80 <= setup_light_length_n79 & setup_light_length_n42;
    setup_light_length_n81 <= signed(resize(setup_light_length_n78, 7)) - signed(resize(setup_light_length_n80, 7));
    setup_light_length_n82 <= unsigned(setup_light_length_n81(6 downto 6));
    -- setup.half.length
    setup_half_length_n1015 <= signed(resize(setup_half_length_n1014_s5, 3)) - signed(resize(setup_light_length_n42, 3));
    setup_half_length_n1016 <= unsigned(setup_half_length_n1015(2 downto 2));
    setup_half_length_n1017 <= signed(resize(setup_half_length_n1014_s5, 3)) when setup_half_length_n1016(0) = '1' else setup_half_length_n1015;
    setup_half_length_n1018 <= unsigned(setup_half_length_n1017(1 downto 0));
    setup_half_length_n1019 <= setup_half_length_n1016 xor setup_light_length_n42;
    setup_half_length_n1023 <= setup_half_length_n1018 & setup_half_length_n1022_s5;
    setup_half_length_n1024 <= setup_half_length_n1019 & setup_light_length_n43;
    setup_half_length_n1025 <= setup_half_length_n1024 & setup_light_length_n42;
    setup_half_length_n1026 <= signed(resize(setup_half_length_n1023, 5)) - signed(resize(setup_half_length_n1025, 5));
    setup_half_length_n1027 <= unsigned(setup_half_length_n1026(4 downto 4));
    setup_half_length_n1028 <= signed(resize(setup_half_length_n1023, 5)) when setup_half_length_n1027(0) = '1' else setup_half_length_n1026;
    setup_half_length_n1029 <= unsigned(setup_half_length_n1028(2 downto 0));
    setup_half_length_n1030 <= setup_half_length_n1027 xor setup_light_length_n42;
    setup_half_length_n1031 <= setup_half_length_n1019 & setup_half_length_n1030;
    setup_half_length_n1035 <= setup_half_length_n1029 & setup_half_length_n1034_s5;
    setup_half_length_n1036 <= setup_half_length_n1031 & setup_light_length_n43;
    setup_half_length_n1037 <= setup_half_length_n1036 & setup_light_length_n42;
    setup_half_length_n1038 <= signed(resize(setup_half_length_n1035, 6)) - signed(resize(setup_half_length_n1037, 6));
    setup_half_length_n1039 <= unsigned(setup_half_length_n1038(5 downto 5));
    setup_half_length_n1040 <= signed(resize(setup_half_length_n1035, 6)) when setup_half_length_n1039(0) = '1' else setup_half_length_n1038;
    setup_half_length_n1041 <= unsigned(setup_half_length_n1040(3 downto 0));
    setup_half_length_n1042 <= setup_half_length_n1039 xor setup_light_length_n42;
    setup_half_length_n1043 <= setup_half_length_n1031 & setup_half_length_n1042;
    setup_half_length_n1047 <= setup_half_length_n1041 & setup_half_length_n1046_s5;
    setup_half_length_n1048 <= setup_half_length_n1043 & setup_light_length_n43;
    setup_half_length_n1049 <= setup_half_length_n1048 & setup_light_length_n42;
    setup_half_length_n1050 <= signed(resize(setup_half_length_n1047, 7)) - signed(resize(setup_half_length_n1049, 7));
    setup_half_length_n1051 <= unsigned(setup_half_length_n1050(6 downto 6));
    -- setup.bump.length
    setup_bump_length_n2081 <= signed(resize(setup_bump_length_n2078_s5, 14)) - signed(resize(setup_bump_length_n2080_s5, 14));
    setup_bump_length_n2082 <= unsigned(setup_bump_length_n2081(13 downto 13));
    setup_bump_length_n2083 <= signed(resize(setup_bump_length_n2078_s5, 14)) when setup_bump_length_n2082(0) = '1' else setup_bump_length_n2081;
    setup_bump_length_n2084 <= unsigned(setup_bump_length_n2083(11 downto 0));
    setup_bump_length_n2085 <= setup_bump_length_n2082 xor setup_light_length_n42;
    setup_bump_length_n2086 <= setup_bump_length_n2074_s5 & setup_bump_length_n2085;
    setup_bump_length_n2090 <= setup_bump_length_n2084 & setup_bump_length_n2089_s5;
    setup_bump_length_n2091 <= setup_bump_length_n2086 & setup_light_length_n43;
    setup_bump_length_n2092 <= setup_bump_length_n2091 & setup_light_length_n42;
    setup_bump_length_n2093 <= signed(resize(setup_bump_length_n2090, 15)) - signed(resize(setup_bump_length_n2092, 15));
    setup_bump_length_n2094 <= unsigned(setup_bump_length_n2093(14 downto 14));
    setup_bump_length_n2095 <= signed(resize(setup_bump_length_n2090, 15)) when setup_bump_length_n2094(0) = '1' else setup_bump_length_n2093;
    setup_bump_length_n2096 <= unsigned(setup_bump_length_n2095(12 downto 0));
    setup_bump_length_n2097 <= setup_bump_length_n2094 xor setup_light_length_n42;
    setup_bump_length_n2098 <= setup_bump_length_n2086 & setup_bump_length_n2097;
    setup_bump_length_n2102 <= setup_bump_length_n2096 & setup_bump_length_n2101_s5;
    setup_bump_length_n2103 <= setup_bump_length_n2098 & setup_light_length_n43;
    setup_bump_length_n2104 <= setup_bump_length_n2103 & setup_light_length_n42;
    setup_bump_length_n2105 <= signed(resize(setup_bump_length_n2102, 16)) - signed(resize(setup_bump_length_n2104, 16));
    setup_bump_length_n2106 <= unsigned(setup_bump_length_n2105(15 downto 15));
    setup_bump_length_n2107 <= signed(resize(setup_bump_length_n2102, 16)) when setup_bump_length_n2106(0) = '1' else setup_bump_length_n2105;
    setup_bump_length_n2108 <= unsigned(setup_bump_length_n2107(13 downto 0));
    setup_bump_length_n2109 <= setup_bump_length_n2106 xor setup_light_length_n42;
    setup_bump_length_n2110 <= setup_bump_length_n2098 & setup_bump_length_n2109;
    setup_bump_length_n2114 <= setup_bump_length_n2108 & setup_bump_length_n2113_s5;
    setup_bump_length_n2115 <= setup_bump_length_n2110 & setup_light_length_n43;
    setup_bump_length_n2116 <= setup_bump_length_n2115 & setup_light_length_n42;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_length_n74_s6 <= setup_light_length_n74;
                setup_light_length_n78_s6 <= setup_light_length_n78;
                setup_light_length_n81_s6 <= setup_light_length_n81;
                setup_light_length_n82_s6 <= setup_light_length_n82;
                setup_light_length_n89_s6 <= setup_light_length_n89_s5;
                setup_light_length_n101_s6 <= setup_light_length_n101_s5;
                setup_light_length_n113_s6 <= setup_light_length_n113_s5;
                setup_light_length_n125_s6 <= setup_light_length_n125_s5;
                setup_light_length_n137_s6 <= setup_light_length_n137_s5;
                setup_light_length_n149_s6 <= setup_light_length_n149_s5;
                setup_light_length_n161_s6 <= setup_light_length_n161_s5;
                setup_light_length_n173_s6 <= setup_light_length_n173_s5;
                setup_light_length_n185_s6 <= setup_light_length_n185_s5;
                setup_light_length_n197_s6 <= setup_light_length_n197_s5;
                setup_light_length_n209_s6 <= setup_light_length_n209_s5;
                setup_light_length_n221_s6 <= setup_light_length_n221_s5;
                setup_light_length_n233_s6 <= setup_light_length_n233_s5;
                setup_light_length_n245_s6 <= setup_light_length_n245_s5;
                setup_light_length_n257_s6 <= setup_light_length_n257_s5;
                setup_light_length_n269_s6 <= setup_light_length_n269_s5;
                setup_light_length_n281_s6 <= setup_light_length_n281_s5;
                setup_light_length_n293_s6 <= setup_light_length_n293_s5;
                setup_light_length_n305_s6 <= setup_light_length_n305_s5;
                setup_light_length_n317_s6 <= setup_light_length_n317_s5;
                setup_light_length_n327_s6 <= setup_light_length_n327_s5;
                setup_light_unit_x_n385_s6 <= setup_light_unit_x_n385_s5;
                setup_light_unit_x_n395_s6 <= setup_light_unit_x_n395_s5;
                setup_light_unit_x_n396_s6 <= setup_light_unit_x_n396_s5;
                setup_light_unit_x_n402_s6 <= setup_light_unit_x_n402_s5;
                setup_light_unit_x_n555_s6 <= setup_light_unit_x_n555_s5;
                setup_light_unit_x_n557_s6 <= setup_light_unit_x_n557_s5;
                setup_light_unit_y_n602_s6 <= setup_light_unit_y_n602_s5;
                setup_light_unit_y_n611_s6 <= setup_light_unit_y_n611_s5;
                setup_light_unit_y_n617_s6 <= setup_light_unit_y_n617_s5;
                setup_light_unit_y_n769_s6 <= setup_light_unit_y_n769_s5;
                setup_light_unit_y_n771_s6 <= setup_light_unit_y_n771_s5;
                setup_light_unit_z_n816_s6 <= setup_light_unit_z_n816_s5;
                setup_light_unit_z_n825_s6 <= setup_light_unit_z_n825_s5;
                setup_light_unit_z_n831_s6 <= setup_light_unit_z_n831_s5;
                setup_light_unit_z_n983_s6 <= setup_light_unit_z_n983_s5;
                setup_light_unit_z_n985_s6 <= setup_light_unit_z_n985_s5;
                setup_half_length_n1043_s6 <= setup_half_length_n1043;
                setup_half_length_n1047_s6 <= setup_half_length_n1047;
                setup_half_length_n1050_s6 <= setup_half_length_n1050;
                setup_half_length_n1051_s6 <= setup_half_length_n1051;
                setup_half_length_n1058_s6 <= setup_half_length_n1058_s5;
                setup_half_length_n1070_s6 <= setup_half_length_n1070_s5;
                setup_half_length_n1082_s6 <= setup_half_length_n1082_s5;
                setup_half_length_n1094_s6 <= setup_half_length_n1094_s5;
                setup_half_length_n1106_s6 <= setup_half_length_n1106_s5;
                setup_half_length_n1118_s6 <= setup_half_length_n1118_s5;
                setup_half_length_n1130_s6 <= setup_half_length_n1130_s5;
                setup_half_length_n1142_s6 <= setup_half_length_n1142_s5;
                setup_half_length_n1154_s6 <= setup_half_length_n1154_s5;
                setup_half_length_n1166_s6 <= setup_half_length_n1166_s5;
                setup_half_length_n1178_s6 <= setup_half_length_n1178_s5;
                setup_half_length_n1190_s6 <= setup_half_length_n1190_s5;
                setup_half_length_n1202_s6 <= setup_half_length_n1202_s5;
                setup_half_length_n1214_s6 <= setup_half_length_n1214_s5;
                setup_half_length_n1226_s6 <= setup_half_length_n1226_s5;
                setup_half_length_n1238_s6 <= setup_half_length_n1238_s5;
                setup_half_length_n1250_s6 <= setup_half_length_n1250_s5;
                setup_half_length_n1262_s6 <= setup_half_length_n1262_s5;
                setup_half_length_n1274_s6 <= setup_half_length_n1274_s5;
                setup_half_length_n1286_s6 <= setup_half_length_n1286_s5;
                setup_half_unit_x_n1352_s6 <= setup_half_unit_x_n1352_s5;
                setup_half_unit_x_n1361_s6 <= setup_half_unit_x_n1361_s5;
                setup_half_unit_x_n1367_s6 <= setup_half_unit_x_n1367_s5;
                setup_half_unit_x_n1520_s6 <= setup_half_unit_x_n1520_s5;
                setup_half_unit_x_n1522_s6 <= setup_half_unit_x_n1522_s5;
                setup_half_unit_y_n1567_s6 <= setup_half_unit_y_n1567_s5;
                setup_half_unit_y_n1576_s6 <= setup_half_unit_y_n1576_s5;
                setup_half_unit_y_n1582_s6 <= setup_half_unit_y_n1582_s5;
                setup_half_unit_y_n1734_s6 <= setup_half_unit_y_n1734_s5;
                setup_half_unit_y_n1736_s6 <= setup_half_unit_y_n1736_s5;
                setup_half_unit_z_n1781_s6 <= setup_half_unit_z_n1781_s5;
                setup_half_unit_z_n1790_s6 <= setup_half_unit_z_n1790_s5;
                setup_half_unit_z_n1796_s6 <= setup_half_unit_z_n1796_s5;
                setup_half_unit_z_n1948_s6 <= setup_half_unit_z_n1948_s5;
                setup_half_unit_z_n1950_s6 <= setup_half_unit_z_n1950_s5;
                setup_bump_length_n2110_s6 <= setup_bump_length_n2110;
                setup_bump_length_n2114_s6 <= setup_bump_length_n2114;
                setup_bump_length_n2116_s6 <= setup_bump_length_n2116;
                setup_bump_length_n2125_s6 <= setup_bump_length_n2125_s5;
                setup_bump_length_n2137_s6 <= setup_bump_length_n2137_s5;
                setup_bump_length_n2149_s6 <= setup_bump_length_n2149_s5;
                setup_bump_length_n2161_s6 <= setup_bump_length_n2161_s5;
                setup_bump_length_n2173_s6 <= setup_bump_length_n2173_s5;
                setup_bump_unit_x_n2251_s6 <= setup_bump_unit_x_n2251_s5;
                setup_bump_unit_x_n2259_s6 <= setup_bump_unit_x_n2259_s5;
                setup_bump_unit_x_n2417_s6 <= setup_bump_unit_x_n2417_s5;
                setup_bump_unit_x_n2419_s6 <= setup_bump_unit_x_n2419_s5;
                setup_bump_unit_y_n2458_s6 <= setup_bump_unit_y_n2458_s5;
                setup_bump_unit_y_n2466_s6 <= setup_bump_unit_y_n2466_s5;
                setup_bump_unit_y_n2623_s6 <= setup_bump_unit_y_n2623_s5;
                setup_bump_unit_y_n2625_s6 <= setup_bump_unit_y_n2625_s5;
                setup_bump_unit_z_n2664_s6 <= setup_bump_unit_z_n2664_s5;
                setup_bump_unit_z_n2672_s6 <= setup_bump_unit_z_n2672_s5;
                setup_bump_unit_z_n2829_s6 <= setup_bump_unit_z_n2829_s5;
                setup_bump_unit_z_n2831_s6 <= setup_bump_unit_z_n2831_s5;
            end if;
            if rst = '1' then
                valid_s6 <= '0';
            elsif ce = '1' then
                valid_s6 <= valid_s5;
            end if;
        end if;
    end process;

    -- ---- stage 6 ----
    -- setup.light.length
    setup_light_length_n83 <= signed(resize(setup_light_length_n78_s6, 7)) when setup_light_length_n82_s6(0) = '1' else setup_light_length_n81_s6;
    setup_light_length_n84 <= unsigned(setup_light_length_n83(4 downto 0));
    setup_light_length_n85 <= setup_light_length_n82_s6 xor setup_light_length_n42;
    setup_light_length_n86 <= setup_light_length_n74_s6 & setup_light_length_n85;
    setup_light_length_n90 <= setup_light_length_n84 & setup_light_length_n89_s6;
    setup_light_length_n91 <= setup_light_length_n86 & setup_light_length_n43;
    setup_light_length_n92 <= setup_light_length_n91 & setup_light_length_n42;
    setup_light_length_n93 <= signed(resize(setup_light_length_n90, 8)) - signed(resize(setup_light_length_n92, 8));
    setup_light_length_n94 <= unsigned(setup_light_length_n93(7 downto 7));
    setup_light_length_n95 <= signed(resize(setup_light_length_n90, 8)) when setup_light_length_n94(0) = '1' else setup_light_length_n93;
    setup_light_length_n96 <= unsigned(setup_light_length_n95(5 downto 0));
    setup_light_length_n97 <= setup_light_length_n94 xor setup_light_length_n42;
    setup_light_length_n98 <= setup_light_length_n86 & setup_light_length_n97;
    setup_light_length_n102 <= setup_light_length_n96 & setup_light_length_n101_s6;
    setup_light_length_n103 <= setup_light_length_n98 & setup_light_length_n43;
    setup_light_length_n104 <= setup_light_length_n103 & setup_light_length_n42;
    setup_light_length_n105 <= signed(resize(setup_light_length_n102, 9)) - signed(resize(setup_light_length_n104, 9));
    setup_light_length_n106 <= unsigned(setup_light_length_n105(8 downto 8));
    setup_light_length_n107 <= signed(resize(setup_light_length_n102, 9)) when setup_light_length_n106(0) = '1' else setup_light_length_n105;
    setup_light_length_n108 <= unsigned(setup_light_length_n107(6 downto 0));
    setup_light_length_n109 <= setup_light_length_n106 xor setup_light_length_n42;
    setup_light_length_n110 <= setup_light_length_n98 & setup_light_length_n109;
    setup_light_length_n114 <= setup_light_length_n108 & setup_light_length_n113_s6;
    setup_light_length_n115 <= setup_light_length_n110 & setup_light_length_n43;
    setup_light_length_n116 <= setup_light_length_n115 & setup_light_length_n42;
    setup_light_length_n117 <= signed(resize(setup_light_length_n114, 10)) - signed(resize(setup_light_length_n116, 10));
    setup_light_length_n118 <= unsigned(setup_light_length_n117(9 downto 9));
    setup_light_length_n119 <= signed(resize(setup_light_length_n114, 10)) when setup_light_length_n118(0) = '1' else setup_light_length_n117;
    setup_light_length_n120 <= unsigned(setup_light_length_n119(7 downto 0));
    setup_light_length_n121 <= setup_light_length_n118 xor setup_light_length_n42;
    setup_light_length_n122 <= setup_light_length_n110 & setup_light_length_n121;
    setup_light_length_n126 <= setup_light_length_n120 & setup_light_length_n125_s6;
    setup_light_length_n127 <= setup_light_length_n122 & setup_light_length_n43;
    setup_light_length_n128 <= setup_light_length_n127 & setup_light_length_n42;
    -- setup.half.length
    setup_half_length_n1052 <= signed(resize(setup_half_length_n1047_s6, 7)) when setup_half_length_n1051_s6(0) = '1' else setup_half_length_n1050_s6;
    setup_half_length_n1053 <= unsigned(setup_half_length_n1052(4 downto 0));
    setup_half_length_n1054 <= setup_half_length_n1051_s6 xor setup_light_length_n42;
    setup_half_length_n1055 <= setup_half_length_n1043_s6 & setup_half_length_n1054;
    setup_half_length_n1059 <= setup_half_length_n1053 & setup_half_length_n1058_s6;
    setup_half_length_n1060 <= setup_half_length_n1055 & setup_light_length_n43;
    setup_half_length_n1061 <= setup_half_length_n1060 & setup_light_length_n42;
    setup_half_length_n1062 <= signed(resize(setup_half_length_n1059, 8)) - signed(resize(setup_half_length_n1061, 8));
    setup_half_length_n1063 <= unsigned(setup_half_length_n1062(7 downto 7));
    setup_half_length_n1064 <= signed(resize(setup_half_length_n1059, 8)) when setup_half_length_n1063(0) = '1' else setup_half_length_n1062;
    setup_half_length_n1065 <= unsigned(setup_half_length_n1064(5 downto 0));
    setup_half_length_n1066 <= setup_half_length_n1063 xor setup_light_length_n42;
    setup_half_length_n1067 <= setup_half_length_n1055 & setup_half_length_n1066;
    setup_half_length_n1071 <= setup_half_length_n1065 & setup_half_length_n1070_s6;
    setup_half_length_n1072 <= setup_half_length_n1067 & setup_light_length_n43;
    setup_half_length_n1073 <= setup_half_length_n1072 & setup_light_length_n42;
    setup_half_length_n1074 <= signed(resize(setup_half_length_n1071, 9)) - signed(resize(setup_half_length_n1073, 9));
    setup_half_length_n1075 <= unsigned(setup_half_length_n1074(8 downto 8));
    setup_half_length_n1076 <= signed(resize(setup_half_length_n1071, 9)) when setup_half_length_n1075(0) = '1' else setup_half_length_n1074;
    setup_half_length_n1077 <= unsigned(setup_half_length_n1076(6 downto 0));
    setup_half_length_n1078 <= setup_half_length_n1075 xor setup_light_length_n42;
    setup_half_length_n1079 <= setup_half_length_n1067 & setup_half_length_n1078;
    setup_half_length_n1083 <= setup_half_length_n1077 & setup_half_length_n1082_s6;
    setup_half_length_n1084 <= setup_half_length_n1079 & setup_light_length_n43;
    setup_half_length_n1085 <= setup_half_length_n1084 & setup_light_length_n42;
    setup_half_length_n1086 <= signed(resize(setup_half_length_n1083, 10)) - signed(resize(setup_half_length_n1085, 10));
    setup_half_length_n1087 <= unsigned(setup_half_length_n1086(9 downto 9));
    setup_half_length_n1088 <= signed(resize(setup_half_length_n1083, 10)) when setup_half_length_n1087(0) = '1' else setup_half_length_n1086;
    setup_half_length_n1089 <= unsigned(setup_half_length_n1088(7 downto 0));
    setup_half_length_n1090 <= setup_half_length_n1087 xor setup_light_length_n42;
    setup_half_length_n1091 <= setup_half_length_n1079 & setup_half_length_n1090;
    setup_half_length_n1095 <= setup_half_length_n1089 & setup_half_length_n1094_s6;
    setup_half_length_n1096 <= setup_half_length_n1091 & setup_light_length_n43;
    setup_half_length_n1097 <= setup_half_length_n1096 & setup_light_length_n42;
    -- setup.bump.length
    setup_bump_length_n2117 <= signed(resize(setup_bump_length_n2114_s6, 17)) - signed(resize(setup_bump_length_n2116_s6, 17));
    setup_bump_length_n2118 <= unsigned(setup_bump_length_n2117(16 downto 16));
    setup_bump_length_n2119 <= signed(resize(setup_bump_length_n2114_s6, 17)) when setup_bump_length_n2118(0) = '1' else setup_bump_length_n2117;
    setup_bump_length_n2120 <= unsigned(setup_bump_length_n2119(14 downto 0));
    setup_bump_length_n2121 <= setup_bump_length_n2118 xor setup_light_length_n42;
    setup_bump_length_n2122 <= setup_bump_length_n2110_s6 & setup_bump_length_n2121;
    setup_bump_length_n2126 <= setup_bump_length_n2120 & setup_bump_length_n2125_s6;
    setup_bump_length_n2127 <= setup_bump_length_n2122 & setup_light_length_n43;
    setup_bump_length_n2128 <= setup_bump_length_n2127 & setup_light_length_n42;
    setup_bump_length_n2129 <= signed(resize(setup_bump_length_n2126, 18)) - signed(resize(setup_bump_length_n2128, 18));
    setup_bump_length_n2130 <= unsigned(setup_bump_length_n2129(17 downto 17));
    setup_bump_length_n2131 <= signed(resize(setup_bump_length_n2126, 18)) when setup_bump_length_n2130(0) = '1' else setup_bump_length_n2129;
    setup_bump_length_n2132 <= unsigned(setup_bump_length_n2131(15 downto 0));
    setup_bump_length_n2133 <= setup_bump_length_n2130 xor setup_light_length_n42;
    setup_bump_length_n2134 <= setup_bump_length_n2122 & setup_bump_length_n2133;
    setup_bump_length_n2138 <= setup_bump_length_n2132 & setup_bump_length_n2137_s6;
    setup_bump_length_n2139 <= setup_bump_length_n2134 & setup_light_length_n43;
    setup_bump_length_n2140 <= setup_bump_length_n2139 & setup_light_length_n42;
    setup_bump_length_n2141 <= signed(resize(setup_bump_length_n2138, 19)) - signed(resize(setup_bump_length_n2140, 19));
    setup_bump_length_n2142 <= unsigned(setup_bump_length_n2141(18 downto 18));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_length_n122_s7 <= setup_light_length_n122;
                setup_light_length_n126_s7 <= setup_light_length_n126;
                setup_light_length_n128_s7 <= setup_light_length_n128;
                setup_light_length_n137_s7 <= setup_light_length_n137_s6;
                setup_light_length_n149_s7 <= setup_light_length_n149_s6;
                setup_light_length_n161_s7 <= setup_light_length_n161_s6;
                setup_light_length_n173_s7 <= setup_light_length_n173_s6;
                setup_light_length_n185_s7 <= setup_light_length_n185_s6;
                setup_light_length_n197_s7 <= setup_light_length_n197_s6;
                setup_light_length_n209_s7 <= setup_light_length_n209_s6;
                setup_light_length_n221_s7 <= setup_light_length_n221_s6;
                setup_light_length_n233_s7 <= setup_light_length_n233_s6;
                setup_light_length_n245_s7 <= setup_light_length_n245_s6;
                setup_light_length_n257_s7 <= setup_light_length_n257_s6;
                setup_light_length_n269_s7 <= setup_light_length_n269_s6;
                setup_light_length_n281_s7 <= setup_light_length_n281_s6;
                setup_light_length_n293_s7 <= setup_light_length_n293_s6;
                setup_light_length_n305_s7 <= setup_light_length_n305_s6;
                setup_light_length_n317_s7 <= setup_light_length_n317_s6;
                setup_light_length_n327_s7 <= setup_light_length_n327_s6;
                setup_light_unit_x_n385_s7 <= setup_light_unit_x_n385_s6;
                setup_light_unit_x_n395_s7 <= setup_light_unit_x_n395_s6;
                setup_light_unit_x_n396_s7 <= setup_light_unit_x_n396_s6;
                setup_light_unit_x_n402_s7 <= setup_light_unit_x_n402_s6;
                setup_light_unit_x_n555_s7 <= setup_light_unit_x_n555_s6;
                setup_light_unit_x_n557_s7 <= setup_light_unit_x_n557_s6;
                setup_light_unit_y_n602_s7 <= setup_light_unit_y_n602_s6;
                setup_light_unit_y_n611_s7 <= setup_light_unit_y_n611_s6;
                setup_light_unit_y_n617_s7 <= setup_light_unit_y_n617_s6;
                setup_light_unit_y_n769_s7 <= setup_light_unit_y_n769_s6;
                setup_light_unit_y_n771_s7 <= setup_light_unit_y_n771_s6;
                setup_light_unit_z_n816_s7 <= setup_light_unit_z_n816_s6;
                setup_light_unit_z_n825_s7 <= setup_light_unit_z_n825_s6;
                setup_light_unit_z_n831_s7 <= setup_light_unit_z_n831_s6;
                setup_light_unit_z_n983_s7 <= setup_light_unit_z_n983_s6;
                setup_light_unit_z_n985_s7 <= setup_light_unit_z_n985_s6;
                setup_half_length_n1091_s7 <= setup_half_length_n1091;
                setup_half_length_n1095_s7 <= setup_half_length_n1095;
                setup_half_length_n1097_s7 <= setup_half_length_n1097;
                setup_half_length_n1106_s7 <= setup_half_length_n1106_s6;
                setup_half_length_n1118_s7 <= setup_half_length_n1118_s6;
                setup_half_length_n1130_s7 <= setup_half_length_n1130_s6;
                setup_half_length_n1142_s7 <= setup_half_length_n1142_s6;
                setup_half_length_n1154_s7 <= setup_half_length_n1154_s6;
                setup_half_length_n1166_s7 <= setup_half_length_n1166_s6;
                setup_half_length_n1178_s7 <= setup_half_length_n1178_s6;
                setup_half_length_n1190_s7 <= setup_half_length_n1190_s6;
                setup_half_length_n1202_s7 <= setup_half_length_n1202_s6;
                setup_half_length_n1214_s7 <= setup_half_length_n1214_s6;
                setup_half_length_n1226_s7 <= setup_half_length_n1226_s6;
                setup_half_length_n1238_s7 <= setup_half_length_n1238_s6;
                setup_half_length_n1250_s7 <= setup_half_length_n1250_s6;
                setup_half_length_n1262_s7 <= setup_half_length_n1262_s6;
                setup_half_length_n1274_s7 <= setup_half_length_n1274_s6;
                setup_half_length_n1286_s7 <= setup_half_length_n1286_s6;
                setup_half_unit_x_n1352_s7 <= setup_half_unit_x_n1352_s6;
                setup_half_unit_x_n1361_s7 <= setup_half_unit_x_n1361_s6;
                setup_half_unit_x_n1367_s7 <= setup_half_unit_x_n1367_s6;
                setup_half_unit_x_n1520_s7 <= setup_half_unit_x_n1520_s6;
                setup_half_unit_x_n1522_s7 <= setup_half_unit_x_n1522_s6;
                setup_half_unit_y_n1567_s7 <= setup_half_unit_y_n1567_s6;
                setup_half_unit_y_n1576_s7 <= setup_half_unit_y_n1576_s6;
                setup_half_unit_y_n1582_s7 <= setup_half_unit_y_n1582_s6;
                setup_half_unit_y_n1734_s7 <= setup_half_unit_y_n1734_s6;
                setup_half_unit_y_n1736_s7 <= setup_half_unit_y_n1736_s6;
                setup_half_unit_z_n1781_s7 <= setup_half_unit_z_n1781_s6;
                setup_half_unit_z_n1790_s7 <= setup_half_unit_z_n1790_s6;
                setup_half_unit_z_n1796_s7 <= setup_half_unit_z_n1796_s6;
                setup_half_unit_z_n1948_s7 <= setup_half_unit_z_n1948_s6;
                setup_half_unit_z_n1950_s7 <= setup_half_unit_z_n1950_s6;
                setup_bump_length_n2134_s7 <= setup_bump_length_n2134;
                setup_bump_length_n2138_s7 <= setup_bump_length_n2138;
                setup_bump_length_n2141_s7 <= setup_bump_length_n2141;
                setup_bump_length_n2142_s7 <= setup_bump_length_n2142;
                setup_bump_length_n2149_s7 <= setup_bump_length_n2149_s6;
                setup_bump_length_n2161_s7 <= setup_bump_length_n2161_s6;
                setup_bump_length_n2173_s7 <= setup_bump_length_n2173_s6;
                setup_bump_unit_x_n2251_s7 <= setup_bump_unit_x_n2251_s6;
                setup_bump_unit_x_n2259_s7 <= setup_bump_unit_x_n2259_s6;
                setup_bump_unit_x_n2417_s7 <= setup_bump_unit_x_n2417_s6;
                setup_bump_unit_x_n2419_s7 <= setup_bump_unit_x_n2419_s6;
                setup_bump_unit_y_n2458_s7 <= setup_bump_unit_y_n2458_s6;
                setup_bump_unit_y_n2466_s7 <= setup_bump_unit_y_n2466_s6;
                setup_bump_unit_y_n2623_s7 <= setup_bump_unit_y_n2623_s6;
                setup_bump_unit_y_n2625_s7 <= setup_bump_unit_y_n2625_s6;
                setup_bump_unit_z_n2664_s7 <= setup_bump_unit_z_n2664_s6;
                setup_bump_unit_z_n2672_s7 <= setup_bump_unit_z_n2672_s6;
                setup_bump_unit_z_n2829_s7 <= setup_bump_unit_z_n2829_s6;
                setup_bump_unit_z_n2831_s7 <= setup_bump_unit_z_n2831_s6;
            end if;
            if rst = '1' then
                valid_s7 <= '0';
            elsif ce = '1' then
                valid_s7 <= valid_s6;
            end if;
        end if;
    end process;

    -- ---- stage 7 ----
    -- setup.light.length
    setup_light_length_n129 <= signed(resize(setup_light_length_n126_s7, 11)) - signed(resize(setup_light_length_n128_s7, 11));
    setup_light_length_n130 <= unsigned(setup_light_length_n129(10 downto 10));
    setup_light_length_n131 <= signed(resize(setup_light_length_n126_s7, 11)) when setup_light_length_n130(0) = '1' else setup_light_length_n129;
    setup_light_length_n132 <= unsigned(setup_light_length_n131(8 downto 0));
    setup_light_length_n133 <= setup_light_length_n130 xor setup_light_length_n42;
    setup_light_length_n134 <= setup_light_length_n122_s7 & setup_light_length_n133;
    setup_light_length_n138 <= setup_light_length_n132 & setup_light_length_n137_s7;
    setup_light_length_n139 <= setup_light_length_n134 & setup_light_length_n43;
    setup_light_length_n140 <= setup_light_length_n139 & setup_light_length_n42;
    setup_light_length_n141 <= signed(resize(setup_light_length_n138, 12)) - signed(resize(setup_light_length_n140, 12));
    setup_light_length_n142 <= unsigned(setup_light_length_n141(11 downto 11));
    setup_light_length_n143 <= signed(resize(setup_light_length_n138, 12)) when setup_light_length_n142(0) = '1' else setup_light_length_n141;
    setup_light_length_n144 <= unsigned(setup_light_length_n143(9 downto 0));
    setup_light_length_n145 <= setup_light_length_n142 xor setup_light_length_n42;
    setup_light_length_n146 <= setup_light_length_n134 & setup_light_length_n145;
    setup_light_length_n150 <= setup_light_length_n144 & setup_light_length_n149_s7;
    setup_light_length_n151 <= setup_light_length_n146 & setup_light_length_n43;
    setup_light_length_n152 <= setup_light_length_n151 & setup_light_length_n42;
    setup_light_length_n153 <= signed(resize(setup_light_length_n150, 13)) - signed(resize(setup_light_length_n152, 13));
    setup_light_length_n154 <= unsigned(setup_light_length_n153(12 downto 12));
    setup_light_length_n155 <= signed(resize(setup_light_length_n150, 13)) when setup_light_length_n154(0) = '1' else setup_light_length_n153;
    setup_light_length_n156 <= unsigned(setup_light_length_n155(10 downto 0));
    setup_light_length_n157 <= setup_light_length_n154 xor setup_light_length_n42;
    setup_light_length_n158 <= setup_light_length_n146 & setup_light_length_n157;
    setup_light_length_n162 <= setup_light_length_n156 & setup_light_length_n161_s7;
    setup_light_length_n163 <= setup_light_length_n158 & setup_light_length_n43;
    setup_light_length_n164 <= setup_light_length_n163 & setup_light_length_n42;
    -- setup.half.length
    setup_half_length_n1098 <= signed(resize(setup_half_length_n1095_s7, 11)) - signed(resize(setup_half_length_n1097_s7, 11));
    setup_half_length_n1099 <= unsigned(setup_half_length_n1098(10 downto 10));
    setup_half_length_n1100 <= signed(resize(setup_half_length_n1095_s7, 11)) when setup_half_length_n1099(0) = '1' else setup_half_length_n1098;
    setup_half_length_n1101 <= unsigned(setup_half_length_n1100(8 downto 0));
    setup_half_length_n1102 <= setup_half_length_n1099 xor setup_light_length_n42;
    setup_half_length_n1103 <= setup_half_length_n1091_s7 & setup_half_length_n1102;
    setup_half_length_n1107 <= setup_half_length_n1101 & setup_half_length_n1106_s7;
    setup_half_length_n1108 <= setup_half_length_n1103 & setup_light_length_n43;
    setup_half_length_n1109 <= setup_half_length_n1108 & setup_light_length_n42;
    setup_half_length_n1110 <= signed(resize(setup_half_length_n1107, 12)) - signed(resize(setup_half_length_n1109, 12));
    setup_half_length_n1111 <= unsigned(setup_half_length_n1110(11 downto 11));
    setup_half_length_n1112 <= signed(resize(setup_half_length_n1107, 12)) when setup_half_length_n1111(0) = '1' else setup_half_length_n1110;
    setup_half_length_n1113 <= unsigned(setup_half_length_n1112(9 downto 0));
    setup_half_length_n1114 <= setup_half_length_n1111 xor setup_light_length_n42;
    setup_half_length_n1115 <= setup_half_length_n1103 & setup_half_length_n1114;
    setup_half_length_n1119 <= setup_half_length_n1113 & setup_half_length_n1118_s7;
    setup_half_length_n1120 <= setup_half_length_n1115 & setup_light_length_n43;
    setup_half_length_n1121 <= setup_half_length_n1120 & setup_light_length_n42;
    setup_half_length_n1122 <= signed(resize(setup_half_length_n1119, 13)) - signed(resize(setup_half_length_n1121, 13));
    setup_half_length_n1123 <= unsigned(setup_half_length_n1122(12 downto 12));
    setup_half_length_n1124 <= signed(resize(setup_half_length_n1119, 13)) when setup_half_length_n1123(0) = '1' else setup_half_length_n1122;
    setup_half_length_n1125 <= unsigned(setup_half_length_n1124(10 downto 0));
    setup_half_length_n1126 <= setup_half_length_n1123 xor setup_light_length_n42;
    setup_half_length_n1127 <= setup_half_length_n1115 & setup_half_length_n1126;
    setup_half_length_n1131 <= setup_half_length_n1125 & setup_half_length_n1130_s7;
    setup_half_length_n1132 <= setup_half_length_n1127 & setup_light_length_n43;
    setup_half_length_n1133 <= setup_half_length_n1132 & setup_light_length_n42;
    -- setup.bump.length
    setup_bump_length_n2143 <= signed(resize(setup_bump_length_n2138_s7, 19)) when setup_bump_length_n2142_s7(0) = '1' else setup_bump_length_n2141_s7;
    setup_bump_length_n2144 <= unsigned(setup_bump_length_n2143(16 downto 0));
    setup_bump_length_n2145 <= setup_bump_length_n2142_s7 xor setup_light_length_n42;
    setup_bump_length_n2146 <= setup_bump_length_n2134_s7 & setup_bump_length_n2145;
    setup_bump_length_n2150 <= setup_bump_length_n2144 & setup_bump_length_n2149_s7;
    setup_bump_length_n2151 <= setup_bump_length_n2146 & setup_light_length_n43;
    setup_bump_length_n2152 <= setup_bump_length_n2151 & setup_light_length_n42;
    setup_bump_length_n2153 <= signed(resize(setup_bump_length_n2150, 20)) - signed(resize(setup_bump_length_n2152, 20));
    setup_bump_length_n2154 <= unsigned(setup_bump_length_n2153(19 downto 19));
    setup_bump_length_n2155 <= signed(resize(setup_bump_length_n2150, 20)) when setup_bump_length_n2154(0) = '1' else setup_bump_length_n2153;
    setup_bump_length_n2156 <= unsigned(setup_bump_length_n2155(17 downto 0));
    setup_bump_length_n2157 <= setup_bump_length_n2154 xor setup_light_length_n42;
    setup_bump_length_n2158 <= setup_bump_length_n2146 & setup_bump_length_n2157;
    setup_bump_length_n2162 <= setup_bump_length_n2156 & setup_bump_length_n2161_s7;
    setup_bump_length_n2163 <= setup_bump_length_n2158 & setup_light_length_n43;
    setup_bump_length_n2164 <= setup_bump_length_n2163 & setup_light_length_n42;
    setup_bump_length_n2165 <= signed(resize(setup_bump_length_n2162, 21)) - signed(resize(setup_bump_length_n2164, 21));
    setup_bump_length_n2166 <= unsigned(setup_bump_length_n2165(20 downto 20));
    setup_bump_length_n2167 <= signed(resize(setup_bump_length_n2162, 21)) when setup_bump_length_n2166(0) = '1' else setup_bump_length_n2165;
    setup_bump_length_n2168 <= unsigned(setup_bump_length_n2167(18 downto 0));
    setup_bump_length_n2169 <= setup_bump_length_n2166 xor setup_light_length_n42;
    setup_bump_length_n2170 <= setup_bump_length_n2158 & setup_bump_length_n2169;
    setup_bump_length_n2174 <= setup_bump_length_n2168 & setup_bump_length_n2173_s7;
    setup_bump_length_n2175 <= setup_bump_length_n2170 & setup_light_length_n43;
    setup_bump_length_n2176 <= setup_bump_length_n2175 & setup_light_length_n42;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_length_n158_s8 <= setup_light_length_n158;
                setup_light_length_n162_s8 <= setup_light_length_n162;
                setup_light_length_n164_s8 <= setup_light_length_n164;
                setup_light_length_n173_s8 <= setup_light_length_n173_s7;
                setup_light_length_n185_s8 <= setup_light_length_n185_s7;
                setup_light_length_n197_s8 <= setup_light_length_n197_s7;
                setup_light_length_n209_s8 <= setup_light_length_n209_s7;
                setup_light_length_n221_s8 <= setup_light_length_n221_s7;
                setup_light_length_n233_s8 <= setup_light_length_n233_s7;
                setup_light_length_n245_s8 <= setup_light_length_n245_s7;
                setup_light_length_n257_s8 <= setup_light_length_n257_s7;
                setup_light_length_n269_s8 <= setup_light_length_n269_s7;
                setup_light_length_n281_s8 <= setup_light_length_n281_s7;
                setup_light_length_n293_s8 <= setup_light_length_n293_s7;
                setup_light_length_n305_s8 <= setup_light_length_n305_s7;
                setup_light_length_n317_s8 <= setup_light_length_n317_s7;
                setup_light_length_n327_s8 <= setup_light_length_n327_s7;
                setup_light_unit_x_n385_s8 <= setup_light_unit_x_n385_s7;
                setup_light_unit_x_n395_s8 <= setup_light_unit_x_n395_s7;
                setup_light_unit_x_n396_s8 <= setup_light_unit_x_n396_s7;
                setup_light_unit_x_n402_s8 <= setup_light_unit_x_n402_s7;
                setup_light_unit_x_n555_s8 <= setup_light_unit_x_n555_s7;
                setup_light_unit_x_n557_s8 <= setup_light_unit_x_n557_s7;
                setup_light_unit_y_n602_s8 <= setup_light_unit_y_n602_s7;
                setup_light_unit_y_n611_s8 <= setup_light_unit_y_n611_s7;
                setup_light_unit_y_n617_s8 <= setup_light_unit_y_n617_s7;
                setup_light_unit_y_n769_s8 <= setup_light_unit_y_n769_s7;
                setup_light_unit_y_n771_s8 <= setup_light_unit_y_n771_s7;
                setup_light_unit_z_n816_s8 <= setup_light_unit_z_n816_s7;
                setup_light_unit_z_n825_s8 <= setup_light_unit_z_n825_s7;
                setup_light_unit_z_n831_s8 <= setup_light_unit_z_n831_s7;
                setup_light_unit_z_n983_s8 <= setup_light_unit_z_n983_s7;
                setup_light_unit_z_n985_s8 <= setup_light_unit_z_n985_s7;
                setup_half_length_n1127_s8 <= setup_half_length_n1127;
                setup_half_length_n1131_s8 <= setup_half_length_n1131;
                setup_half_length_n1133_s8 <= setup_half_length_n1133;
                setup_half_length_n1142_s8 <= setup_half_length_n1142_s7;
                setup_half_length_n1154_s8 <= setup_half_length_n1154_s7;
                setup_half_length_n1166_s8 <= setup_half_length_n1166_s7;
                setup_half_length_n1178_s8 <= setup_half_length_n1178_s7;
                setup_half_length_n1190_s8 <= setup_half_length_n1190_s7;
                setup_half_length_n1202_s8 <= setup_half_length_n1202_s7;
                setup_half_length_n1214_s8 <= setup_half_length_n1214_s7;
                setup_half_length_n1226_s8 <= setup_half_length_n1226_s7;
                setup_half_length_n1238_s8 <= setup_half_length_n1238_s7;
                setup_half_length_n1250_s8 <= setup_half_length_n1250_s7;
                setup_half_length_n1262_s8 <= setup_half_length_n1262_s7;
                setup_half_length_n1274_s8 <= setup_half_length_n1274_s7;
                setup_half_length_n1286_s8 <= setup_half_length_n1286_s7;
                setup_half_unit_x_n1352_s8 <= setup_half_unit_x_n1352_s7;
                setup_half_unit_x_n1361_s8 <= setup_half_unit_x_n1361_s7;
                setup_half_unit_x_n1367_s8 <= setup_half_unit_x_n1367_s7;
                setup_half_unit_x_n1520_s8 <= setup_half_unit_x_n1520_s7;
                setup_half_unit_x_n1522_s8 <= setup_half_unit_x_n1522_s7;
                setup_half_unit_y_n1567_s8 <= setup_half_unit_y_n1567_s7;
                setup_half_unit_y_n1576_s8 <= setup_half_unit_y_n1576_s7;
                setup_half_unit_y_n1582_s8 <= setup_half_unit_y_n1582_s7;
                setup_half_unit_y_n1734_s8 <= setup_half_unit_y_n1734_s7;
                setup_half_unit_y_n1736_s8 <= setup_half_unit_y_n1736_s7;
                setup_half_unit_z_n1781_s8 <= setup_half_unit_z_n1781_s7;
                setup_half_unit_z_n1790_s8 <= setup_half_unit_z_n1790_s7;
                setup_half_unit_z_n1796_s8 <= setup_half_unit_z_n1796_s7;
                setup_half_unit_z_n1948_s8 <= setup_half_unit_z_n1948_s7;
                setup_half_unit_z_n1950_s8 <= setup_half_unit_z_n1950_s7;
                setup_bump_length_n2170_s8 <= setup_bump_length_n2170;
                setup_bump_length_n2174_s8 <= setup_bump_length_n2174;
                setup_bump_length_n2176_s8 <= setup_bump_length_n2176;
                setup_bump_unit_x_n2251_s8 <= setup_bump_unit_x_n2251_s7;
                setup_bump_unit_x_n2259_s8 <= setup_bump_unit_x_n2259_s7;
                setup_bump_unit_x_n2417_s8 <= setup_bump_unit_x_n2417_s7;
                setup_bump_unit_x_n2419_s8 <= setup_bump_unit_x_n2419_s7;
                setup_bump_unit_y_n2458_s8 <= setup_bump_unit_y_n2458_s7;
                setup_bump_unit_y_n2466_s8 <= setup_bump_unit_y_n2466_s7;
                setup_bump_unit_y_n2623_s8 <= setup_bump_unit_y_n2623_s7;
                setup_bump_unit_y_n2625_s8 <= setup_bump_unit_y_n2625_s7;
                setup_bump_unit_z_n2664_s8 <= setup_bump_unit_z_n2664_s7;
                setup_bump_unit_z_n2672_s8 <= setup_bump_unit_z_n2672_s7;
                setup_bump_unit_z_n2829_s8 <= setup_bump_unit_z_n2829_s7;
                setup_bump_unit_z_n2831_s8 <= setup_bump_unit_z_n2831_s7;
            end if;
            if rst = '1' then
                valid_s8 <= '0';
            elsif ce = '1' then
                valid_s8 <= valid_s7;
            end if;
        end if;
    end process;

    -- ---- stage 8 ----
    -- setup.light.length
    setup_light_length_n165 <= signed(resize(setup_light_length_n162_s8, 14)) - signed(resize(setup_light_length_n164_s8, 14));
    setup_light_length_n166 <= unsigned(setup_light_length_n165(13 downto 13));
    setup_light_length_n167 <= signed(resize(setup_light_length_n162_s8, 14)) when setup_light_length_n166(0) = '1' else setup_light_length_n165;
    setup_light_length_n168 <= unsigned(setup_light_length_n167(11 downto 0));
    setup_light_length_n169 <= setup_light_length_n166 xor setup_light_length_n42;
    setup_light_length_n170 <= setup_light_length_n158_s8 & setup_light_length_n169;
    setup_light_length_n174 <= setup_light_length_n168 & setup_light_length_n173_s8;
    setup_light_length_n175 <= setup_light_length_n170 & setup_light_length_n43;
    setup_light_length_n176 <= setup_light_length_n175 & setup_light_length_n42;
    setup_light_length_n177 <= signed(resize(setup_light_length_n174, 15)) - signed(resize(setup_light_length_n176, 15));
    setup_light_length_n178 <= unsigned(setup_light_length_n177(14 downto 14));
    setup_light_length_n179 <= signed(resize(setup_light_length_n174, 15)) when setup_light_length_n178(0) = '1' else setup_light_length_n177;
    setup_light_length_n180 <= unsigned(setup_light_length_n179(12 downto 0));
    setup_light_length_n181 <= setup_light_length_n178 xor setup_light_length_n42;
    setup_light_length_n182 <= setup_light_length_n170 & setup_light_length_n181;
    setup_light_length_n186 <= setup_light_length_n180 & setup_light_length_n185_s8;
    setup_light_length_n187 <= setup_light_length_n182 & setup_light_length_n43;
    setup_light_length_n188 <= setup_light_length_n187 & setup_light_length_n42;
    setup_light_length_n189 <= signed(resize(setup_light_length_n186, 16)) - signed(resize(setup_light_length_n188, 16));
    setup_light_length_n190 <= unsigned(setup_light_length_n189(15 downto 15));
    setup_light_length_n191 <= signed(resize(setup_light_length_n186, 16)) when setup_light_length_n190(0) = '1' else setup_light_length_n189;
    setup_light_length_n192 <= unsigned(setup_light_length_n191(13 downto 0));
    setup_light_length_n193 <= setup_light_length_n190 xor setup_light_length_n42;
    setup_light_length_n194 <= setup_light_length_n182 & setup_light_length_n193;
    setup_light_length_n198 <= setup_light_length_n192 & setup_light_length_n197_s8;
    setup_light_length_n199 <= setup_light_length_n194 & setup_light_length_n43;
    setup_light_length_n200 <= setup_light_length_n199 & setup_light_length_n42;
    -- setup.half.length
    setup_half_length_n1134 <= signed(resize(setup_half_length_n1131_s8, 14)) - signed(resize(setup_half_length_n1133_s8, 14));
    setup_half_length_n1135 <= unsigned(setup_half_length_n1134(13 downto 13));
    setup_half_length_n1136 <= signed(resize(setup_half_length_n1131_s8, 14)) when setup_half_length_n1135(0) = '1' else setup_half_length_n1134;
    setup_half_length_n1137 <= unsigned(setup_half_length_n1136(11 downto 0));
    setup_half_length_n1138 <= setup_half_length_n1135 xor setup_light_length_n42;
    setup_half_length_n1139 <= setup_half_length_n1127_s8 & setup_half_length_n1138;
    setup_half_length_n1143 <= setup_half_length_n1137 & setup_half_length_n1142_s8;
    setup_half_length_n1144 <= setup_half_length_n1139 & setup_light_length_n43;
    setup_half_length_n1145 <= setup_half_length_n1144 & setup_light_length_n42;
    setup_half_length_n1146 <= signed(resize(setup_half_length_n1143, 15)) - signed(resize(setup_half_length_n1145, 15));
    setup_half_length_n1147 <= unsigned(setup_half_length_n1146(14 downto 14));
    setup_half_length_n1148 <= signed(resize(setup_half_length_n1143, 15)) when setup_half_length_n1147(0) = '1' else setup_half_length_n1146;
    setup_half_length_n1149 <= unsigned(setup_half_length_n1148(12 downto 0));
    setup_half_length_n1150 <= setup_half_length_n1147 xor setup_light_length_n42;
    setup_half_length_n1151 <= setup_half_length_n1139 & setup_half_length_n1150;
    setup_half_length_n1155 <= setup_half_length_n1149 & setup_half_length_n1154_s8;
    setup_half_length_n1156 <= setup_half_length_n1151 & setup_light_length_n43;
    setup_half_length_n1157 <= setup_half_length_n1156 & setup_light_length_n42;
    setup_half_length_n1158 <= signed(resize(setup_half_length_n1155, 16)) - signed(resize(setup_half_length_n1157, 16));
    setup_half_length_n1159 <= unsigned(setup_half_length_n1158(15 downto 15));
    setup_half_length_n1160 <= signed(resize(setup_half_length_n1155, 16)) when setup_half_length_n1159(0) = '1' else setup_half_length_n1158;
    setup_half_length_n1161 <= unsigned(setup_half_length_n1160(13 downto 0));
    setup_half_length_n1162 <= setup_half_length_n1159 xor setup_light_length_n42;
    setup_half_length_n1163 <= setup_half_length_n1151 & setup_half_length_n1162;
    setup_half_length_n1167 <= setup_half_length_n1161 & setup_half_length_n1166_s8;
    setup_half_length_n1168 <= setup_half_length_n1163 & setup_light_length_n43;
    setup_half_length_n1169 <= setup_half_length_n1168 & setup_light_length_n42;
    -- setup.bump.length
    setup_bump_length_n2177 <= signed(resize(setup_bump_length_n2174_s8, 22)) - signed(resize(setup_bump_length_n2176_s8, 22));
    setup_bump_length_n2178 <= unsigned(setup_bump_length_n2177(21 downto 21));
    setup_bump_length_n2179 <= signed(resize(setup_bump_length_n2174_s8, 22)) when setup_bump_length_n2178(0) = '1' else setup_bump_length_n2177;
    setup_bump_length_n2180 <= unsigned(setup_bump_length_n2179(19 downto 0));
    setup_bump_length_n2181 <= setup_bump_length_n2178 xor setup_light_length_n42;
    setup_bump_length_n2182 <= setup_bump_length_n2170_s8 & setup_bump_length_n2181;
    setup_bump_length_n2183 <= setup_bump_length_n2180 & setup_light_length_n327_s8;
    setup_bump_length_n2184 <= setup_bump_length_n2182 & setup_light_length_n43;
    setup_bump_length_n2185 <= setup_bump_length_n2184 & setup_light_length_n42;
    setup_bump_length_n2186 <= signed(resize(setup_bump_length_n2183, 23)) - signed(resize(setup_bump_length_n2185, 23));
    setup_bump_length_n2187 <= unsigned(setup_bump_length_n2186(22 downto 22));
    setup_bump_length_n2188 <= signed(resize(setup_bump_length_n2183, 23)) when setup_bump_length_n2187(0) = '1' else setup_bump_length_n2186;
    setup_bump_length_n2189 <= unsigned(setup_bump_length_n2188(20 downto 0));
    setup_bump_length_n2190 <= setup_bump_length_n2187 xor setup_light_length_n42;
    setup_bump_length_n2191 <= setup_bump_length_n2182 & setup_bump_length_n2190;
    setup_bump_length_n2192 <= setup_bump_length_n2189 & setup_light_length_n327_s8;
    setup_bump_length_n2193 <= setup_bump_length_n2191 & setup_light_length_n43;
    setup_bump_length_n2194 <= setup_bump_length_n2193 & setup_light_length_n42;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_length_n194_s9 <= setup_light_length_n194;
                setup_light_length_n198_s9 <= setup_light_length_n198;
                setup_light_length_n200_s9 <= setup_light_length_n200;
                setup_light_length_n209_s9 <= setup_light_length_n209_s8;
                setup_light_length_n221_s9 <= setup_light_length_n221_s8;
                setup_light_length_n233_s9 <= setup_light_length_n233_s8;
                setup_light_length_n245_s9 <= setup_light_length_n245_s8;
                setup_light_length_n257_s9 <= setup_light_length_n257_s8;
                setup_light_length_n269_s9 <= setup_light_length_n269_s8;
                setup_light_length_n281_s9 <= setup_light_length_n281_s8;
                setup_light_length_n293_s9 <= setup_light_length_n293_s8;
                setup_light_length_n305_s9 <= setup_light_length_n305_s8;
                setup_light_length_n317_s9 <= setup_light_length_n317_s8;
                setup_light_length_n327_s9 <= setup_light_length_n327_s8;
                setup_light_unit_x_n385_s9 <= setup_light_unit_x_n385_s8;
                setup_light_unit_x_n395_s9 <= setup_light_unit_x_n395_s8;
                setup_light_unit_x_n396_s9 <= setup_light_unit_x_n396_s8;
                setup_light_unit_x_n402_s9 <= setup_light_unit_x_n402_s8;
                setup_light_unit_x_n555_s9 <= setup_light_unit_x_n555_s8;
                setup_light_unit_x_n557_s9 <= setup_light_unit_x_n557_s8;
                setup_light_unit_y_n602_s9 <= setup_light_unit_y_n602_s8;
                setup_light_unit_y_n611_s9 <= setup_light_unit_y_n611_s8;
                setup_light_unit_y_n617_s9 <= setup_light_unit_y_n617_s8;
                setup_light_unit_y_n769_s9 <= setup_light_unit_y_n769_s8;
                setup_light_unit_y_n771_s9 <= setup_light_unit_y_n771_s8;
                setup_light_unit_z_n816_s9 <= setup_light_unit_z_n816_s8;
                setup_light_unit_z_n825_s9 <= setup_light_unit_z_n825_s8;
                setup_light_unit_z_n831_s9 <= setup_light_unit_z_n831_s8;
                setup_light_unit_z_n983_s9 <= setup_light_unit_z_n983_s8;
                setup_light_unit_z_n985_s9 <= setup_light_unit_z_n985_s8;
                setup_half_length_n1163_s9 <= setup_half_length_n1163;
                setup_half_length_n1167_s9 <= setup_half_length_n1167;
                setup_half_length_n1169_s9 <= setup_half_length_n1169;
                setup_half_length_n1178_s9 <= setup_half_length_n1178_s8;
                setup_half_length_n1190_s9 <= setup_half_length_n1190_s8;
                setup_half_length_n1202_s9 <= setup_half_length_n1202_s8;
                setup_half_length_n1214_s9 <= setup_half_length_n1214_s8;
                setup_half_length_n1226_s9 <= setup_half_length_n1226_s8;
                setup_half_length_n1238_s9 <= setup_half_length_n1238_s8;
                setup_half_length_n1250_s9 <= setup_half_length_n1250_s8;
                setup_half_length_n1262_s9 <= setup_half_length_n1262_s8;
                setup_half_length_n1274_s9 <= setup_half_length_n1274_s8;
                setup_half_length_n1286_s9 <= setup_half_length_n1286_s8;
                setup_half_unit_x_n1352_s9 <= setup_half_unit_x_n1352_s8;
                setup_half_unit_x_n1361_s9 <= setup_half_unit_x_n1361_s8;
                setup_half_unit_x_n1367_s9 <= setup_half_unit_x_n1367_s8;
                setup_half_unit_x_n1520_s9 <= setup_half_unit_x_n1520_s8;
                setup_half_unit_x_n1522_s9 <= setup_half_unit_x_n1522_s8;
                setup_half_unit_y_n1567_s9 <= setup_half_unit_y_n1567_s8;
                setup_half_unit_y_n1576_s9 <= setup_half_unit_y_n1576_s8;
                setup_half_unit_y_n1582_s9 <= setup_half_unit_y_n1582_s8;
                setup_half_unit_y_n1734_s9 <= setup_half_unit_y_n1734_s8;
                setup_half_unit_y_n1736_s9 <= setup_half_unit_y_n1736_s8;
                setup_half_unit_z_n1781_s9 <= setup_half_unit_z_n1781_s8;
                setup_half_unit_z_n1790_s9 <= setup_half_unit_z_n1790_s8;
                setup_half_unit_z_n1796_s9 <= setup_half_unit_z_n1796_s8;
                setup_half_unit_z_n1948_s9 <= setup_half_unit_z_n1948_s8;
                setup_half_unit_z_n1950_s9 <= setup_half_unit_z_n1950_s8;
                setup_bump_length_n2191_s9 <= setup_bump_length_n2191;
                setup_bump_length_n2192_s9 <= setup_bump_length_n2192;
                setup_bump_length_n2194_s9 <= setup_bump_length_n2194;
                setup_bump_unit_x_n2251_s9 <= setup_bump_unit_x_n2251_s8;
                setup_bump_unit_x_n2259_s9 <= setup_bump_unit_x_n2259_s8;
                setup_bump_unit_x_n2417_s9 <= setup_bump_unit_x_n2417_s8;
                setup_bump_unit_x_n2419_s9 <= setup_bump_unit_x_n2419_s8;
                setup_bump_unit_y_n2458_s9 <= setup_bump_unit_y_n2458_s8;
                setup_bump_unit_y_n2466_s9 <= setup_bump_unit_y_n2466_s8;
                setup_bump_unit_y_n2623_s9 <= setup_bump_unit_y_n2623_s8;
                setup_bump_unit_y_n2625_s9 <= setup_bump_unit_y_n2625_s8;
                setup_bump_unit_z_n2664_s9 <= setup_bump_unit_z_n2664_s8;
                setup_bump_unit_z_n2672_s9 <= setup_bump_unit_z_n2672_s8;
                setup_bump_unit_z_n2829_s9 <= setup_bump_unit_z_n2829_s8;
                setup_bump_unit_z_n2831_s9 <= setup_bump_unit_z_n2831_s8;
            end if;
            if rst = '1' then
                valid_s9 <= '0';
            elsif ce = '1' then
                valid_s9 <= valid_s8;
            end if;
        end if;
    end process;

    -- ---- stage 9 ----
    -- setup.light.length
    setup_light_length_n201 <= signed(resize(setup_light_length_n198_s9, 17)) - signed(resize(setup_light_length_n200_s9, 17));
    setup_light_length_n202 <= unsigned(setup_light_length_n201(16 downto 16));
    setup_light_length_n203 <= signed(resize(setup_light_length_n198_s9, 17)) when setup_light_length_n202(0) = '1' else setup_light_length_n201;
    setup_light_length_n204 <= unsigned(setup_light_length_n203(14 downto 0));
    setup_light_length_n205 <= setup_light_length_n202 xor setup_light_length_n42;
    setup_light_length_n206 <= setup_light_length_n194_s9 & setup_light_length_n205;
    setup_light_length_n210 <= setup_light_length_n204 & setup_light_length_n209_s9;
    setup_light_length_n211 <= setup_light_length_n206 & setup_light_length_n43;
    setup_light_length_n212 <= setup_light_length_n211 & setup_light_length_n42;
    setup_light_length_n213 <= signed(resize(setup_light_length_n210, 18)) - signed(resize(setup_light_length_n212, 18));
    setup_light_length_n214 <= unsigned(setup_light_length_n213(17 downto 17));
    setup_light_length_n215 <= signed(resize(setup_light_length_n210, 18)) when setup_light_length_n214(0) = '1' else setup_light_length_n213;
    setup_light_length_n216 <= unsigned(setup_light_length_n215(15 downto 0));
    setup_light_length_n217 <= setup_light_length_n214 xor setup_light_length_n42;
    setup_light_length_n218 <= setup_light_length_n206 & setup_light_length_n217;
    setup_light_length_n222 <= setup_light_length_n216 & setup_light_length_n221_s9;
    setup_light_length_n223 <= setup_light_length_n218 & setup_light_length_n43;
    setup_light_length_n224 <= setup_light_length_n223 & setup_light_length_n42;
    setup_light_length_n225 <= signed(resize(setup_light_length_n222, 19)) - signed(resize(setup_light_length_n224, 19));
    setup_light_length_n226 <= unsigned(setup_light_length_n225(18 downto 18));
    -- setup.half.length
    setup_half_length_n1170 <= signed(resize(setup_half_length_n1167_s9, 17)) - signed(resize(setup_half_length_n1169_s9, 17));
    setup_half_length_n1171 <= unsigned(setup_half_length_n1170(16 downto 16));
    setup_half_length_n1172 <= signed(resize(setup_half_length_n1167_s9, 17)) when setup_half_length_n1171(0) = '1' else setup_half_length_n1170;
    setup_half_length_n1173 <= unsigned(setup_half_length_n1172(14 downto 0));
    setup_half_length_n1174 <= setup_half_length_n1171 xor setup_light_length_n42;
    setup_half_length_n1175 <= setup_half_length_n1163_s9 & setup_half_length_n1174;
    setup_half_length_n1179 <= setup_half_length_n1173 & setup_half_length_n1178_s9;
    setup_half_length_n1180 <= setup_half_length_n1175 & setup_light_length_n43;
    setup_half_length_n1181 <= setup_half_length_n1180 & setup_light_length_n42;
    setup_half_length_n1182 <= signed(resize(setup_half_length_n1179, 18)) - signed(resize(setup_half_length_n1181, 18));
    setup_half_length_n1183 <= unsigned(setup_half_length_n1182(17 downto 17));
    setup_half_length_n1184 <= signed(resize(setup_half_length_n1179, 18)) when setup_half_length_n1183(0) = '1' else setup_half_length_n1182;
    setup_half_length_n1185 <= unsigned(setup_half_length_n1184(15 downto 0));
    setup_half_length_n1186 <= setup_half_length_n1183 xor setup_light_length_n42;
    setup_half_length_n1187 <= setup_half_length_n1175 & setup_half_length_n1186;
    setup_half_length_n1191 <= setup_half_length_n1185 & setup_half_length_n1190_s9;
    setup_half_length_n1192 <= setup_half_length_n1187 & setup_light_length_n43;
    setup_half_length_n1193 <= setup_half_length_n1192 & setup_light_length_n42;
    setup_half_length_n1194 <= signed(resize(setup_half_length_n1191, 19)) - signed(resize(setup_half_length_n1193, 19));
    setup_half_length_n1195 <= unsigned(setup_half_length_n1194(18 downto 18));
    -- setup.bump.length
    setup_bump_length_n2195 <= signed(resize(setup_bump_length_n2192_s9, 24)) - signed(resize(setup_bump_length_n2194_s9, 24));
    setup_bump_length_n2196 <= unsigned(setup_bump_length_n2195(23 downto 23));
    setup_bump_length_n2197 <= signed(resize(setup_bump_length_n2192_s9, 24)) when setup_bump_length_n2196(0) = '1' else setup_bump_length_n2195;
    setup_bump_length_n2198 <= unsigned(setup_bump_length_n2197(21 downto 0));
    setup_bump_length_n2199 <= setup_bump_length_n2196 xor setup_light_length_n42;
    setup_bump_length_n2200 <= setup_bump_length_n2191_s9 & setup_bump_length_n2199;
    setup_bump_length_n2201 <= setup_bump_length_n2198 & setup_light_length_n327_s9;
    setup_bump_length_n2202 <= setup_bump_length_n2200 & setup_light_length_n43;
    setup_bump_length_n2203 <= setup_bump_length_n2202 & setup_light_length_n42;
    setup_bump_length_n2204 <= signed(resize(setup_bump_length_n2201, 25)) - signed(resize(setup_bump_length_n2203, 25));
    setup_bump_length_n2205 <= unsigned(setup_bump_length_n2204(24 downto 24));
    setup_bump_length_n2206 <= signed(resize(setup_bump_length_n2201, 25)) when setup_bump_length_n2205(0) = '1' else setup_bump_length_n2204;
    setup_bump_length_n2207 <= unsigned(setup_bump_length_n2206(22 downto 0));
    setup_bump_length_n2208 <= setup_bump_length_n2205 xor setup_light_length_n42;
    setup_bump_length_n2209 <= setup_bump_length_n2200 & setup_bump_length_n2208;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_length_n218_s10 <= setup_light_length_n218;
                setup_light_length_n222_s10 <= setup_light_length_n222;
                setup_light_length_n225_s10 <= setup_light_length_n225;
                setup_light_length_n226_s10 <= setup_light_length_n226;
                setup_light_length_n233_s10 <= setup_light_length_n233_s9;
                setup_light_length_n245_s10 <= setup_light_length_n245_s9;
                setup_light_length_n257_s10 <= setup_light_length_n257_s9;
                setup_light_length_n269_s10 <= setup_light_length_n269_s9;
                setup_light_length_n281_s10 <= setup_light_length_n281_s9;
                setup_light_length_n293_s10 <= setup_light_length_n293_s9;
                setup_light_length_n305_s10 <= setup_light_length_n305_s9;
                setup_light_length_n317_s10 <= setup_light_length_n317_s9;
                setup_light_length_n327_s10 <= setup_light_length_n327_s9;
                setup_light_unit_x_n385_s10 <= setup_light_unit_x_n385_s9;
                setup_light_unit_x_n395_s10 <= setup_light_unit_x_n395_s9;
                setup_light_unit_x_n396_s10 <= setup_light_unit_x_n396_s9;
                setup_light_unit_x_n402_s10 <= setup_light_unit_x_n402_s9;
                setup_light_unit_x_n555_s10 <= setup_light_unit_x_n555_s9;
                setup_light_unit_x_n557_s10 <= setup_light_unit_x_n557_s9;
                setup_light_unit_y_n602_s10 <= setup_light_unit_y_n602_s9;
                setup_light_unit_y_n611_s10 <= setup_light_unit_y_n611_s9;
                setup_light_unit_y_n617_s10 <= setup_light_unit_y_n617_s9;
                setup_light_unit_y_n769_s10 <= setup_light_unit_y_n769_s9;
                setup_light_unit_y_n771_s10 <= setup_light_unit_y_n771_s9;
                setup_light_unit_z_n816_s10 <= setup_light_unit_z_n816_s9;
                setup_light_unit_z_n825_s10 <= setup_light_unit_z_n825_s9;
                setup_light_unit_z_n831_s10 <= setup_light_unit_z_n831_s9;
                setup_light_unit_z_n983_s10 <= setup_light_unit_z_n983_s9;
                setup_light_unit_z_n985_s10 <= setup_light_unit_z_n985_s9;
                setup_half_length_n1187_s10 <= setup_half_length_n1187;
                setup_half_length_n1191_s10 <= setup_half_length_n1191;
                setup_half_length_n1194_s10 <= setup_half_length_n1194;
                setup_half_length_n1195_s10 <= setup_half_length_n1195;
                setup_half_length_n1202_s10 <= setup_half_length_n1202_s9;
                setup_half_length_n1214_s10 <= setup_half_length_n1214_s9;
                setup_half_length_n1226_s10 <= setup_half_length_n1226_s9;
                setup_half_length_n1238_s10 <= setup_half_length_n1238_s9;
                setup_half_length_n1250_s10 <= setup_half_length_n1250_s9;
                setup_half_length_n1262_s10 <= setup_half_length_n1262_s9;
                setup_half_length_n1274_s10 <= setup_half_length_n1274_s9;
                setup_half_length_n1286_s10 <= setup_half_length_n1286_s9;
                setup_half_unit_x_n1352_s10 <= setup_half_unit_x_n1352_s9;
                setup_half_unit_x_n1361_s10 <= setup_half_unit_x_n1361_s9;
                setup_half_unit_x_n1367_s10 <= setup_half_unit_x_n1367_s9;
                setup_half_unit_x_n1520_s10 <= setup_half_unit_x_n1520_s9;
                setup_half_unit_x_n1522_s10 <= setup_half_unit_x_n1522_s9;
                setup_half_unit_y_n1567_s10 <= setup_half_unit_y_n1567_s9;
                setup_half_unit_y_n1576_s10 <= setup_half_unit_y_n1576_s9;
                setup_half_unit_y_n1582_s10 <= setup_half_unit_y_n1582_s9;
                setup_half_unit_y_n1734_s10 <= setup_half_unit_y_n1734_s9;
                setup_half_unit_y_n1736_s10 <= setup_half_unit_y_n1736_s9;
                setup_half_unit_z_n1781_s10 <= setup_half_unit_z_n1781_s9;
                setup_half_unit_z_n1790_s10 <= setup_half_unit_z_n1790_s9;
                setup_half_unit_z_n1796_s10 <= setup_half_unit_z_n1796_s9;
                setup_half_unit_z_n1948_s10 <= setup_half_unit_z_n1948_s9;
                setup_half_unit_z_n1950_s10 <= setup_half_unit_z_n1950_s9;
                setup_bump_length_n2207_s10 <= setup_bump_length_n2207;
                setup_bump_length_n2209_s10 <= setup_bump_length_n2209;
                setup_bump_unit_x_n2251_s10 <= setup_bump_unit_x_n2251_s9;
                setup_bump_unit_x_n2259_s10 <= setup_bump_unit_x_n2259_s9;
                setup_bump_unit_x_n2417_s10 <= setup_bump_unit_x_n2417_s9;
                setup_bump_unit_x_n2419_s10 <= setup_bump_unit_x_n2419_s9;
                setup_bump_unit_y_n2458_s10 <= setup_bump_unit_y_n2458_s9;
                setup_bump_unit_y_n2466_s10 <= setup_bump_unit_y_n2466_s9;
                setup_bump_unit_y_n2623_s10 <= setup_bump_unit_y_n2623_s9;
                setup_bump_unit_y_n2625_s10 <= setup_bump_unit_y_n2625_s9;
                setup_bump_unit_z_n2664_s10 <= setup_bump_unit_z_n2664_s9;
                setup_bump_unit_z_n2672_s10 <= setup_bump_unit_z_n2672_s9;
                setup_bump_unit_z_n2829_s10 <= setup_bump_unit_z_n2829_s9;
                setup_bump_unit_z_n2831_s10 <= setup_bump_unit_z_n2831_s9;
            end if;
            if rst = '1' then
                valid_s10 <= '0';
            elsif ce = '1' then
                valid_s10 <= valid_s9;
            end if;
        end if;
    end process;

    -- ---- stage 10 ----
    -- setup.light.length
    setup_light_length_n227 <= signed(resize(setup_light_length_n222_s10, 19)) when setup_light_length_n226_s10(0) = '1' else setup_light_length_n225_s10;
    setup_light_length_n228 <= unsigned(setup_light_length_n227(16 downto 0));
    setup_light_length_n229 <= setup_light_length_n226_s10 xor setup_light_length_n42;
    setup_light_length_n230 <= setup_light_length_n218_s10 & setup_light_length_n229;
    setup_light_length_n234 <= setup_light_length_n228 & setup_light_length_n233_s10;
    setup_light_length_n235 <= setup_light_length_n230 & setup_light_length_n43;
    setup_light_length_n236 <= setup_light_length_n235 & setup_light_length_n42;
    setup_light_length_n237 <= signed(resize(setup_light_length_n234, 20)) - signed(resize(setup_light_length_n236, 20));
    setup_light_length_n238 <= unsigned(setup_light_length_n237(19 downto 19));
    setup_light_length_n239 <= signed(resize(setup_light_length_n234, 20)) when setup_light_length_n238(0) = '1' else setup_light_length_n237;
    setup_light_length_n240 <= unsigned(setup_light_length_n239(17 downto 0));
    setup_light_length_n241 <= setup_light_length_n238 xor setup_light_length_n42;
    setup_light_length_n242 <= setup_light_length_n230 & setup_light_length_n241;
    setup_light_length_n246 <= setup_light_length_n240 & setup_light_length_n245_s10;
    setup_light_length_n247 <= setup_light_length_n242 & setup_light_length_n43;
    setup_light_length_n248 <= setup_light_length_n247 & setup_light_length_n42;
    setup_light_length_n249 <= signed(resize(setup_light_length_n246, 21)) - signed(resize(setup_light_length_n248, 21));
    setup_light_length_n250 <= unsigned(setup_light_length_n249(20 downto 20));
    setup_light_length_n251 <= signed(resize(setup_light_length_n246, 21)) when setup_light_length_n250(0) = '1' else setup_light_length_n249;
    setup_light_length_n252 <= unsigned(setup_light_length_n251(18 downto 0));
    setup_light_length_n253 <= setup_light_length_n250 xor setup_light_length_n42;
    setup_light_length_n254 <= setup_light_length_n242 & setup_light_length_n253;
    setup_light_length_n258 <= setup_light_length_n252 & setup_light_length_n257_s10;
    setup_light_length_n259 <= setup_light_length_n254 & setup_light_length_n43;
    setup_light_length_n260 <= setup_light_length_n259 & setup_light_length_n42;
    -- setup.half.length
    setup_half_length_n1196 <= signed(resize(setup_half_length_n1191_s10, 19)) when setup_half_length_n1195_s10(0) = '1' else setup_half_length_n1194_s10;
    setup_half_length_n1197 <= unsigned(setup_half_length_n1196(16 downto 0));
    setup_half_length_n1198 <= setup_half_length_n1195_s10 xor setup_light_length_n42;
    setup_half_length_n1199 <= setup_half_length_n1187_s10 & setup_half_length_n1198;
    setup_half_length_n1203 <= setup_half_length_n1197 & setup_half_length_n1202_s10;
    setup_half_length_n1204 <= setup_half_length_n1199 & setup_light_length_n43;
    setup_half_length_n1205 <= setup_half_length_n1204 & setup_light_length_n42;
    setup_half_length_n1206 <= signed(resize(setup_half_length_n1203, 20)) - signed(resize(setup_half_length_n1205, 20));
    setup_half_length_n1207 <= unsigned(setup_half_length_n1206(19 downto 19));
    setup_half_length_n1208 <= signed(resize(setup_half_length_n1203, 20)) when setup_half_length_n1207(0) = '1' else setup_half_length_n1206;
    setup_half_length_n1209 <= unsigned(setup_half_length_n1208(17 downto 0));
    setup_half_length_n1210 <= setup_half_length_n1207 xor setup_light_length_n42;
    setup_half_length_n1211 <= setup_half_length_n1199 & setup_half_length_n1210;
    setup_half_length_n1215 <= setup_half_length_n1209 & setup_half_length_n1214_s10;
    setup_half_length_n1216 <= setup_half_length_n1211 & setup_light_length_n43;
    setup_half_length_n1217 <= setup_half_length_n1216 & setup_light_length_n42;
    setup_half_length_n1218 <= signed(resize(setup_half_length_n1215, 21)) - signed(resize(setup_half_length_n1217, 21));
    setup_half_length_n1219 <= unsigned(setup_half_length_n1218(20 downto 20));
    setup_half_length_n1220 <= signed(resize(setup_half_length_n1215, 21)) when setup_half_length_n1219(0) = '1' else setup_half_length_n1218;
    setup_half_length_n1221 <= unsigned(setup_half_length_n1220(18 downto 0));
    setup_half_length_n1222 <= setup_half_length_n1219 xor setup_light_length_n42;
    setup_half_length_n1223 <= setup_half_length_n1211 & setup_half_length_n1222;
    setup_half_length_n1227 <= setup_half_length_n1221 & setup_half_length_n1226_s10;
    setup_half_length_n1228 <= setup_half_length_n1223 & setup_light_length_n43;
    setup_half_length_n1229 <= setup_half_length_n1228 & setup_light_length_n42;
    -- setup.bump.length
    setup_bump_length_n2210 <= "1" when setup_bump_length_n2207_s10 = resize(setup_light_length_n43, 23) else "0";
    setup_bump_length_n2211 <= setup_bump_length_n2210 xor setup_light_length_n42;
    setup_bump_length_n2212 <= setup_bump_length_n2209_s10 & setup_bump_length_n2211;
    setup_bump_length_n2213 <= setup_bump_length_n2212;
    setup_bump_length_length_sum <= resize(setup_bump_length_n2213, 24) + 24x"000002";
    setup_bump_length_length_cut <= setup_bump_length_length_sum(23 downto 2);
    setup_bump_length_length <= resize(setup_bump_length_length_cut, 23);
    -- setup.bump.unit_x
    setup_bump_unit_x_n2216 <= setup_bump_length_length;
    setup_bump_unit_x_n2252 <= "1" when resize(setup_bump_unit_x_n2251_s10, 23) < setup_bump_unit_x_n2216 else "0";
    setup_bump_unit_x_n2260_term <= resize(setup_bump_unit_x_n2216, 26) xor (25 downto 0 => setup_light_unit_x_n396_s10(0));
    setup_bump_unit_x_n2260 <= resize(setup_bump_unit_x_n2259_s10, 26) + signed(setup_bump_unit_x_n2260_term) + setup_light_unit_x_n396_s10(0);
    setup_bump_unit_x_n2261 <= setup_bump_unit_x_n2260(23 downto 0);
    setup_bump_unit_x_n2262 <= unsigned(setup_bump_unit_x_n2261(23 downto 23));
    setup_bump_unit_x_n2264 <= unsigned(setup_bump_unit_x_n2261);
    setup_bump_unit_x_n2265 <= setup_bump_unit_x_n2264 & setup_light_length_n43;
    setup_bump_unit_x_n2266 <= signed(setup_bump_unit_x_n2265);
    setup_bump_unit_x_n2414 <= "1" when setup_bump_length_length = shift_left(resize(setup_light_length_n43, 23), 18) else "0";
    -- setup.bump.unit_y
    setup_bump_unit_y_n2459 <= "1" when resize(setup_bump_unit_y_n2458_s10, 23) < setup_bump_unit_x_n2216 else "0";
    setup_bump_unit_y_n2467_term <= resize(setup_bump_unit_x_n2216, 26) xor (25 downto 0 => setup_light_unit_x_n396_s10(0));
    setup_bump_unit_y_n2467 <= resize(setup_bump_unit_y_n2466_s10, 26) + signed(setup_bump_unit_y_n2467_term) + setup_light_unit_x_n396_s10(0);
    setup_bump_unit_y_n2468 <= setup_bump_unit_y_n2467(23 downto 0);
    setup_bump_unit_y_n2469 <= unsigned(setup_bump_unit_y_n2468(23 downto 23));
    setup_bump_unit_y_n2471 <= unsigned(setup_bump_unit_y_n2468);
    setup_bump_unit_y_n2472 <= setup_bump_unit_y_n2471 & setup_light_length_n43;
    setup_bump_unit_y_n2473 <= signed(setup_bump_unit_y_n2472);
    -- setup.bump.unit_z
    setup_bump_unit_z_n2665 <= "1" when resize(setup_bump_unit_z_n2664_s10, 23) < setup_bump_unit_x_n2216 else "0";
    setup_bump_unit_z_n2673_term <= resize(setup_bump_unit_x_n2216, 26) xor (25 downto 0 => setup_light_unit_x_n396_s10(0));
    setup_bump_unit_z_n2673 <= resize(setup_bump_unit_z_n2672_s10, 26) + signed(setup_bump_unit_z_n2673_term) + setup_light_unit_x_n396_s10(0);
    setup_bump_unit_z_n2674 <= setup_bump_unit_z_n2673(23 downto 0);
    setup_bump_unit_z_n2675 <= unsigned(setup_bump_unit_z_n2674(23 downto 23));
    setup_bump_unit_z_n2677 <= unsigned(setup_bump_unit_z_n2674);
    setup_bump_unit_z_n2678 <= setup_bump_unit_z_n2677 & setup_light_length_n43;
    setup_bump_unit_z_n2679 <= signed(setup_bump_unit_z_n2678);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_length_n254_s11 <= setup_light_length_n254;
                setup_light_length_n258_s11 <= setup_light_length_n258;
                setup_light_length_n260_s11 <= setup_light_length_n260;
                setup_light_length_n269_s11 <= setup_light_length_n269_s10;
                setup_light_length_n281_s11 <= setup_light_length_n281_s10;
                setup_light_length_n293_s11 <= setup_light_length_n293_s10;
                setup_light_length_n305_s11 <= setup_light_length_n305_s10;
                setup_light_length_n317_s11 <= setup_light_length_n317_s10;
                setup_light_length_n327_s11 <= setup_light_length_n327_s10;
                setup_light_unit_x_n385_s11 <= setup_light_unit_x_n385_s10;
                setup_light_unit_x_n395_s11 <= setup_light_unit_x_n395_s10;
                setup_light_unit_x_n396_s11 <= setup_light_unit_x_n396_s10;
                setup_light_unit_x_n402_s11 <= setup_light_unit_x_n402_s10;
                setup_light_unit_x_n555_s11 <= setup_light_unit_x_n555_s10;
                setup_light_unit_x_n557_s11 <= setup_light_unit_x_n557_s10;
                setup_light_unit_y_n602_s11 <= setup_light_unit_y_n602_s10;
                setup_light_unit_y_n611_s11 <= setup_light_unit_y_n611_s10;
                setup_light_unit_y_n617_s11 <= setup_light_unit_y_n617_s10;
                setup_light_unit_y_n769_s11 <= setup_light_unit_y_n769_s10;
                setup_light_unit_y_n771_s11 <= setup_light_unit_y_n771_s10;
                setup_light_unit_z_n816_s11 <= setup_light_unit_z_n816_s10;
                setup_light_unit_z_n825_s11 <= setup_light_unit_z_n825_s10;
                setup_light_unit_z_n831_s11 <= setup_light_unit_z_n831_s10;
                setup_light_unit_z_n983_s11 <= setup_light_unit_z_n983_s10;
                setup_light_unit_z_n985_s11 <= setup_light_unit_z_n985_s10;
                setup_half_length_n1223_s11 <= setup_half_length_n1223;
                setup_half_length_n1227_s11 <= setup_half_length_n1227;
                setup_half_length_n1229_s11 <= setup_half_length_n1229;
                setup_half_length_n1238_s11 <= setup_half_length_n1238_s10;
                setup_half_length_n1250_s11 <= setup_half_length_n1250_s10;
                setup_half_length_n1262_s11 <= setup_half_length_n1262_s10;
                setup_half_length_n1274_s11 <= setup_half_length_n1274_s10;
                setup_half_length_n1286_s11 <= setup_half_length_n1286_s10;
                setup_half_unit_x_n1352_s11 <= setup_half_unit_x_n1352_s10;
                setup_half_unit_x_n1361_s11 <= setup_half_unit_x_n1361_s10;
                setup_half_unit_x_n1367_s11 <= setup_half_unit_x_n1367_s10;
                setup_half_unit_x_n1520_s11 <= setup_half_unit_x_n1520_s10;
                setup_half_unit_x_n1522_s11 <= setup_half_unit_x_n1522_s10;
                setup_half_unit_y_n1567_s11 <= setup_half_unit_y_n1567_s10;
                setup_half_unit_y_n1576_s11 <= setup_half_unit_y_n1576_s10;
                setup_half_unit_y_n1582_s11 <= setup_half_unit_y_n1582_s10;
                setup_half_unit_y_n1734_s11 <= setup_half_unit_y_n1734_s10;
                setup_half_unit_y_n1736_s11 <= setup_half_unit_y_n1736_s10;
                setup_half_unit_z_n1781_s11 <= setup_half_unit_z_n1781_s10;
                setup_half_unit_z_n1790_s11 <= setup_half_unit_z_n1790_s10;
                setup_half_unit_z_n1796_s11 <= setup_half_unit_z_n1796_s10;
                setup_half_unit_z_n1948_s11 <= setup_half_unit_z_n1948_s10;
                setup_half_unit_z_n1950_s11 <= setup_half_unit_z_n1950_s10;
                setup_bump_unit_x_n2216_s11 <= setup_bump_unit_x_n2216;
                setup_bump_unit_x_n2252_s11 <= setup_bump_unit_x_n2252;
                setup_bump_unit_x_n2262_s11 <= setup_bump_unit_x_n2262;
                setup_bump_unit_x_n2266_s11 <= setup_bump_unit_x_n2266;
                setup_bump_unit_x_n2414_s11 <= setup_bump_unit_x_n2414;
                setup_bump_unit_x_n2417_s11 <= setup_bump_unit_x_n2417_s10;
                setup_bump_unit_x_n2419_s11 <= setup_bump_unit_x_n2419_s10;
                setup_bump_unit_y_n2459_s11 <= setup_bump_unit_y_n2459;
                setup_bump_unit_y_n2469_s11 <= setup_bump_unit_y_n2469;
                setup_bump_unit_y_n2473_s11 <= setup_bump_unit_y_n2473;
                setup_bump_unit_y_n2623_s11 <= setup_bump_unit_y_n2623_s10;
                setup_bump_unit_y_n2625_s11 <= setup_bump_unit_y_n2625_s10;
                setup_bump_unit_z_n2665_s11 <= setup_bump_unit_z_n2665;
                setup_bump_unit_z_n2675_s11 <= setup_bump_unit_z_n2675;
                setup_bump_unit_z_n2679_s11 <= setup_bump_unit_z_n2679;
                setup_bump_unit_z_n2829_s11 <= setup_bump_unit_z_n2829_s10;
                setup_bump_unit_z_n2831_s11 <= setup_bump_unit_z_n2831_s10;
            end if;
            if rst = '1' then
                valid_s11 <= '0';
            elsif ce = '1' then
                valid_s11 <= valid_s10;
            end if;
        end if;
    end process;

    -- ---- stage 11 ----
    -- setup.light.length
    setup_light_length_n261 <= signed(resize(setup_light_length_n258_s11, 22)) - signed(resize(setup_light_length_n260_s11, 22));
    setup_light_length_n262 <= unsigned(setup_light_length_n261(21 downto 21));
    setup_light_length_n263 <= signed(resize(setup_light_length_n258_s11, 22)) when setup_light_length_n262(0) = '1' else setup_light_length_n261;
    setup_light_length_n264 <= unsigned(setup_light_length_n263(19 downto 0));
    setup_light_length_n265 <= setup_light_length_n262 xor setup_light_length_n42;
    setup_light_length_n266 <= setup_light_length_n254_s11 & setup_light_length_n265;
    setup_light_length_n270 <= setup_light_length_n264 & setup_light_length_n269_s11;
    setup_light_length_n271 <= setup_light_length_n266 & setup_light_length_n43;
    setup_light_length_n272 <= setup_light_length_n271 & setup_light_length_n42;
    setup_light_length_n273 <= signed(resize(setup_light_length_n270, 23)) - signed(resize(setup_light_length_n272, 23));
    setup_light_length_n274 <= unsigned(setup_light_length_n273(22 downto 22));
    setup_light_length_n275 <= signed(resize(setup_light_length_n270, 23)) when setup_light_length_n274(0) = '1' else setup_light_length_n273;
    setup_light_length_n276 <= unsigned(setup_light_length_n275(20 downto 0));
    setup_light_length_n277 <= setup_light_length_n274 xor setup_light_length_n42;
    setup_light_length_n278 <= setup_light_length_n266 & setup_light_length_n277;
    setup_light_length_n282 <= setup_light_length_n276 & setup_light_length_n281_s11;
    setup_light_length_n283 <= setup_light_length_n278 & setup_light_length_n43;
    setup_light_length_n284 <= setup_light_length_n283 & setup_light_length_n42;
    -- setup.half.length
    setup_half_length_n1230 <= signed(resize(setup_half_length_n1227_s11, 22)) - signed(resize(setup_half_length_n1229_s11, 22));
    setup_half_length_n1231 <= unsigned(setup_half_length_n1230(21 downto 21));
    setup_half_length_n1232 <= signed(resize(setup_half_length_n1227_s11, 22)) when setup_half_length_n1231(0) = '1' else setup_half_length_n1230;
    setup_half_length_n1233 <= unsigned(setup_half_length_n1232(19 downto 0));
    setup_half_length_n1234 <= setup_half_length_n1231 xor setup_light_length_n42;
    setup_half_length_n1235 <= setup_half_length_n1223_s11 & setup_half_length_n1234;
    setup_half_length_n1239 <= setup_half_length_n1233 & setup_half_length_n1238_s11;
    setup_half_length_n1240 <= setup_half_length_n1235 & setup_light_length_n43;
    setup_half_length_n1241 <= setup_half_length_n1240 & setup_light_length_n42;
    setup_half_length_n1242 <= signed(resize(setup_half_length_n1239, 23)) - signed(resize(setup_half_length_n1241, 23));
    setup_half_length_n1243 <= unsigned(setup_half_length_n1242(22 downto 22));
    setup_half_length_n1244 <= signed(resize(setup_half_length_n1239, 23)) when setup_half_length_n1243(0) = '1' else setup_half_length_n1242;
    setup_half_length_n1245 <= unsigned(setup_half_length_n1244(20 downto 0));
    setup_half_length_n1246 <= setup_half_length_n1243 xor setup_light_length_n42;
    setup_half_length_n1247 <= setup_half_length_n1235 & setup_half_length_n1246;
    setup_half_length_n1251 <= setup_half_length_n1245 & setup_half_length_n1250_s11;
    setup_half_length_n1252 <= setup_half_length_n1247 & setup_light_length_n43;
    setup_half_length_n1253 <= setup_half_length_n1252 & setup_light_length_n42;
    -- setup.bump.unit_x
    setup_bump_unit_x_n2253 <= setup_bump_unit_x_n2252_s11 xor setup_light_length_n42;
    setup_bump_unit_x_n2263 <= setup_bump_unit_x_n2262_s11 xor setup_light_length_n42;
    setup_bump_unit_x_n2267_term <= resize(setup_bump_unit_x_n2216_s11, 26) xor (25 downto 0 => setup_bump_unit_x_n2263(0));
    setup_bump_unit_x_n2267 <= resize(setup_bump_unit_x_n2266_s11, 26) + signed(setup_bump_unit_x_n2267_term) + setup_bump_unit_x_n2263(0);
    setup_bump_unit_x_n2268 <= setup_bump_unit_x_n2267(23 downto 0);
    setup_bump_unit_x_n2269 <= unsigned(setup_bump_unit_x_n2268(23 downto 23));
    setup_bump_unit_x_n2270 <= setup_bump_unit_x_n2269 xor setup_light_length_n42;
    setup_bump_unit_x_n2271 <= unsigned(setup_bump_unit_x_n2268);
    setup_bump_unit_x_n2272 <= setup_bump_unit_x_n2271 & setup_light_length_n43;
    setup_bump_unit_x_n2273 <= signed(setup_bump_unit_x_n2272);
    setup_bump_unit_x_n2274_term <= resize(setup_bump_unit_x_n2216_s11, 26) xor (25 downto 0 => setup_bump_unit_x_n2270(0));
    setup_bump_unit_x_n2274 <= resize(setup_bump_unit_x_n2273, 26) + signed(setup_bump_unit_x_n2274_term) + setup_bump_unit_x_n2270(0);
    setup_bump_unit_x_n2275 <= setup_bump_unit_x_n2274(23 downto 0);
    setup_bump_unit_x_n2276 <= unsigned(setup_bump_unit_x_n2275(23 downto 23));
    setup_bump_unit_x_n2277 <= setup_bump_unit_x_n2276 xor setup_light_length_n42;
    setup_bump_unit_x_n2278 <= unsigned(setup_bump_unit_x_n2275);
    setup_bump_unit_x_n2279 <= setup_bump_unit_x_n2278 & setup_light_length_n43;
    setup_bump_unit_x_n2280 <= signed(setup_bump_unit_x_n2279);
    setup_bump_unit_x_n2394 <= setup_bump_unit_x_n2263 & setup_bump_unit_x_n2270;
    setup_bump_unit_x_n2395 <= setup_bump_unit_x_n2394 & setup_bump_unit_x_n2277;
    setup_bump_unit_x_n2415 <= setup_bump_unit_x_n2253 or setup_bump_unit_x_n2414_s11;
    -- setup.bump.unit_y
    setup_bump_unit_y_n2460 <= setup_bump_unit_y_n2459_s11 xor setup_light_length_n42;
    setup_bump_unit_y_n2470 <= setup_bump_unit_y_n2469_s11 xor setup_light_length_n42;
    setup_bump_unit_y_n2474_term <= resize(setup_bump_unit_x_n2216_s11, 26) xor (25 downto 0 => setup_bump_unit_y_n2470(0));
    setup_bump_unit_y_n2474 <= resize(setup_bump_unit_y_n2473_s11, 26) + signed(setup_bump_unit_y_n2474_term) + setup_bump_unit_y_n2470(0);
    setup_bump_unit_y_n2475 <= setup_bump_unit_y_n2474(23 downto 0);
    setup_bump_unit_y_n2476 <= unsigned(setup_bump_unit_y_n2475(23 downto 23));
    setup_bump_unit_y_n2477 <= setup_bump_unit_y_n2476 xor setup_light_length_n42;
    setup_bump_unit_y_n2478 <= unsigned(setup_bump_unit_y_n2475);
    setup_bump_unit_y_n2479 <= setup_bump_unit_y_n2478 & setup_light_length_n43;
    setup_bump_unit_y_n2480 <= signed(setup_bump_unit_y_n2479);
    setup_bump_unit_y_n2481_term <= resize(setup_bump_unit_x_n2216_s11, 26) xor (25 downto 0 => setup_bump_unit_y_n2477(0));
    setup_bump_unit_y_n2481 <= resize(setup_bump_unit_y_n2480, 26) + signed(setup_bump_unit_y_n2481_term) + setup_bump_unit_y_n2477(0);
    setup_bump_unit_y_n2482 <= setup_bump_unit_y_n2481(23 downto 0);
    setup_bump_unit_y_n2483 <= unsigned(setup_bump_unit_y_n2482(23 downto 23));
    setup_bump_unit_y_n2484 <= setup_bump_unit_y_n2483 xor setup_light_length_n42;
    setup_bump_unit_y_n2485 <= unsigned(setup_bump_unit_y_n2482);
    setup_bump_unit_y_n2486 <= setup_bump_unit_y_n2485 & setup_light_length_n43;
    setup_bump_unit_y_n2487 <= signed(setup_bump_unit_y_n2486);
    setup_bump_unit_y_n2601 <= setup_bump_unit_y_n2470 & setup_bump_unit_y_n2477;
    setup_bump_unit_y_n2602 <= setup_bump_unit_y_n2601 & setup_bump_unit_y_n2484;
    setup_bump_unit_y_n2621 <= setup_bump_unit_y_n2460 or setup_bump_unit_x_n2414_s11;
    -- setup.bump.unit_z
    setup_bump_unit_z_n2666 <= setup_bump_unit_z_n2665_s11 xor setup_light_length_n42;
    setup_bump_unit_z_n2676 <= setup_bump_unit_z_n2675_s11 xor setup_light_length_n42;
    setup_bump_unit_z_n2680_term <= resize(setup_bump_unit_x_n2216_s11, 26) xor (25 downto 0 => setup_bump_unit_z_n2676(0));
    setup_bump_unit_z_n2680 <= resize(setup_bump_unit_z_n2679_s11, 26) + signed(setup_bump_unit_z_n2680_term) + setup_bump_unit_z_n2676(0);
    setup_bump_unit_z_n2681 <= setup_bump_unit_z_n2680(23 downto 0);
    setup_bump_unit_z_n2682 <= unsigned(setup_bump_unit_z_n2681(23 downto 23));
    setup_bump_unit_z_n2683 <= setup_bump_unit_z_n2682 xor setup_light_length_n42;
    setup_bump_unit_z_n2684 <= unsigned(setup_bump_unit_z_n2681);
    setup_bump_unit_z_n2685 <= setup_bump_unit_z_n2684 & setup_light_length_n43;
    setup_bump_unit_z_n2686 <= signed(setup_bump_unit_z_n2685);
    setup_bump_unit_z_n2687_term <= resize(setup_bump_unit_x_n2216_s11, 26) xor (25 downto 0 => setup_bump_unit_z_n2683(0));
    setup_bump_unit_z_n2687 <= resize(setup_bump_unit_z_n2686, 26) + signed(setup_bump_unit_z_n2687_term) + setup_bump_unit_z_n2683(0);
    setup_bump_unit_z_n2688 <= setup_bump_unit_z_n2687(23 downto 0);
    setup_bump_unit_z_n2689 <= unsigned(setup_bump_unit_z_n2688(23 downto 23));
    setup_bump_unit_z_n2690 <= setup_bump_unit_z_n2689 xor setup_light_length_n42;
    setup_bump_unit_z_n2691 <= unsigned(setup_bump_unit_z_n2688);
    setup_bump_unit_z_n2692 <= setup_bump_unit_z_n2691 & setup_light_length_n43;
    setup_bump_unit_z_n2693 <= signed(setup_bump_unit_z_n2692);
    setup_bump_unit_z_n2807 <= setup_bump_unit_z_n2676 & setup_bump_unit_z_n2683;
    setup_bump_unit_z_n2808 <= setup_bump_unit_z_n2807 & setup_bump_unit_z_n2690;
    setup_bump_unit_z_n2827 <= setup_bump_unit_z_n2666 or setup_bump_unit_x_n2414_s11;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_length_n278_s12 <= setup_light_length_n278;
                setup_light_length_n282_s12 <= setup_light_length_n282;
                setup_light_length_n284_s12 <= setup_light_length_n284;
                setup_light_length_n293_s12 <= setup_light_length_n293_s11;
                setup_light_length_n305_s12 <= setup_light_length_n305_s11;
                setup_light_length_n317_s12 <= setup_light_length_n317_s11;
                setup_light_length_n327_s12 <= setup_light_length_n327_s11;
                setup_light_unit_x_n385_s12 <= setup_light_unit_x_n385_s11;
                setup_light_unit_x_n395_s12 <= setup_light_unit_x_n395_s11;
                setup_light_unit_x_n396_s12 <= setup_light_unit_x_n396_s11;
                setup_light_unit_x_n402_s12 <= setup_light_unit_x_n402_s11;
                setup_light_unit_x_n555_s12 <= setup_light_unit_x_n555_s11;
                setup_light_unit_x_n557_s12 <= setup_light_unit_x_n557_s11;
                setup_light_unit_y_n602_s12 <= setup_light_unit_y_n602_s11;
                setup_light_unit_y_n611_s12 <= setup_light_unit_y_n611_s11;
                setup_light_unit_y_n617_s12 <= setup_light_unit_y_n617_s11;
                setup_light_unit_y_n769_s12 <= setup_light_unit_y_n769_s11;
                setup_light_unit_y_n771_s12 <= setup_light_unit_y_n771_s11;
                setup_light_unit_z_n816_s12 <= setup_light_unit_z_n816_s11;
                setup_light_unit_z_n825_s12 <= setup_light_unit_z_n825_s11;
                setup_light_unit_z_n831_s12 <= setup_light_unit_z_n831_s11;
                setup_light_unit_z_n983_s12 <= setup_light_unit_z_n983_s11;
                setup_light_unit_z_n985_s12 <= setup_light_unit_z_n985_s11;
                setup_half_length_n1247_s12 <= setup_half_length_n1247;
                setup_half_length_n1251_s12 <= setup_half_length_n1251;
                setup_half_length_n1253_s12 <= setup_half_length_n1253;
                setup_half_length_n1262_s12 <= setup_half_length_n1262_s11;
                setup_half_length_n1274_s12 <= setup_half_length_n1274_s11;
                setup_half_length_n1286_s12 <= setup_half_length_n1286_s11;
                setup_half_unit_x_n1352_s12 <= setup_half_unit_x_n1352_s11;
                setup_half_unit_x_n1361_s12 <= setup_half_unit_x_n1361_s11;
                setup_half_unit_x_n1367_s12 <= setup_half_unit_x_n1367_s11;
                setup_half_unit_x_n1520_s12 <= setup_half_unit_x_n1520_s11;
                setup_half_unit_x_n1522_s12 <= setup_half_unit_x_n1522_s11;
                setup_half_unit_y_n1567_s12 <= setup_half_unit_y_n1567_s11;
                setup_half_unit_y_n1576_s12 <= setup_half_unit_y_n1576_s11;
                setup_half_unit_y_n1582_s12 <= setup_half_unit_y_n1582_s11;
                setup_half_unit_y_n1734_s12 <= setup_half_unit_y_n1734_s11;
                setup_half_unit_y_n1736_s12 <= setup_half_unit_y_n1736_s11;
                setup_half_unit_z_n1781_s12 <= setup_half_unit_z_n1781_s11;
                setup_half_unit_z_n1790_s12 <= setup_half_unit_z_n1790_s11;
                setup_half_unit_z_n1796_s12 <= setup_half_unit_z_n1796_s11;
                setup_half_unit_z_n1948_s12 <= setup_half_unit_z_n1948_s11;
                setup_half_unit_z_n1950_s12 <= setup_half_unit_z_n1950_s11;
                setup_bump_unit_x_n2216_s12 <= setup_bump_unit_x_n2216_s11;
                setup_bump_unit_x_n2277_s12 <= setup_bump_unit_x_n2277;
                setup_bump_unit_x_n2280_s12 <= setup_bump_unit_x_n2280;
                setup_bump_unit_x_n2395_s12 <= setup_bump_unit_x_n2395;
                setup_bump_unit_x_n2415_s12 <= setup_bump_unit_x_n2415;
                setup_bump_unit_x_n2417_s12 <= setup_bump_unit_x_n2417_s11;
                setup_bump_unit_x_n2419_s12 <= setup_bump_unit_x_n2419_s11;
                setup_bump_unit_y_n2484_s12 <= setup_bump_unit_y_n2484;
                setup_bump_unit_y_n2487_s12 <= setup_bump_unit_y_n2487;
                setup_bump_unit_y_n2602_s12 <= setup_bump_unit_y_n2602;
                setup_bump_unit_y_n2621_s12 <= setup_bump_unit_y_n2621;
                setup_bump_unit_y_n2623_s12 <= setup_bump_unit_y_n2623_s11;
                setup_bump_unit_y_n2625_s12 <= setup_bump_unit_y_n2625_s11;
                setup_bump_unit_z_n2690_s12 <= setup_bump_unit_z_n2690;
                setup_bump_unit_z_n2693_s12 <= setup_bump_unit_z_n2693;
                setup_bump_unit_z_n2808_s12 <= setup_bump_unit_z_n2808;
                setup_bump_unit_z_n2827_s12 <= setup_bump_unit_z_n2827;
                setup_bump_unit_z_n2829_s12 <= setup_bump_unit_z_n2829_s11;
                setup_bump_unit_z_n2831_s12 <= setup_bump_unit_z_n2831_s11;
            end if;
            if rst = '1' then
                valid_s12 <= '0';
            elsif ce = '1' then
                valid_s12 <= valid_s11;
            end if;
        end if;
    end process;

    -- ---- stage 12 ----
    -- setup.light.length
    setup_light_length_n285 <= signed(resize(setup_light_length_n282_s12, 24)) - signed(resize(setup_light_length_n284_s12, 24));
    setup_light_length_n286 <= unsigned(setup_light_length_n285(23 downto 23));
    setup_light_length_n287 <= signed(resize(setup_light_length_n282_s12, 24)) when setup_light_length_n286(0) = '1' else setup_light_length_n285;
    setup_light_length_n288 <= unsigned(setup_light_length_n287(21 downto 0));
    setup_light_length_n289 <= setup_light_length_n286 xor setup_light_length_n42;
    setup_light_length_n290 <= setup_light_length_n278_s12 & setup_light_length_n289;
    setup_light_length_n294 <= setup_light_length_n288 & setup_light_length_n293_s12;
    setup_light_length_n295 <= setup_light_length_n290 & setup_light_length_n43;
    setup_light_length_n296 <= setup_light_length_n295 & setup_light_length_n42;
    setup_light_length_n297 <= signed(resize(setup_light_length_n294, 25)) - signed(resize(setup_light_length_n296, 25));
    setup_light_length_n298 <= unsigned(setup_light_length_n297(24 downto 24));
    setup_light_length_n299 <= signed(resize(setup_light_length_n294, 25)) when setup_light_length_n298(0) = '1' else setup_light_length_n297;
    setup_light_length_n300 <= unsigned(setup_light_length_n299(22 downto 0));
    setup_light_length_n301 <= setup_light_length_n298 xor setup_light_length_n42;
    setup_light_length_n302 <= setup_light_length_n290 & setup_light_length_n301;
    setup_light_length_n306 <= setup_light_length_n300 & setup_light_length_n305_s12;
    setup_light_length_n307 <= setup_light_length_n302 & setup_light_length_n43;
    setup_light_length_n308 <= setup_light_length_n307 & setup_light_length_n42;
    -- setup.half.length
    setup_half_length_n1254 <= signed(resize(setup_half_length_n1251_s12, 24)) - signed(resize(setup_half_length_n1253_s12, 24));
    setup_half_length_n1255 <= unsigned(setup_half_length_n1254(23 downto 23));
    setup_half_length_n1256 <= signed(resize(setup_half_length_n1251_s12, 24)) when setup_half_length_n1255(0) = '1' else setup_half_length_n1254;
    setup_half_length_n1257 <= unsigned(setup_half_length_n1256(21 downto 0));
    setup_half_length_n1258 <= setup_half_length_n1255 xor setup_light_length_n42;
    setup_half_length_n1259 <= setup_half_length_n1247_s12 & setup_half_length_n1258;
    setup_half_length_n1263 <= setup_half_length_n1257 & setup_half_length_n1262_s12;
    setup_half_length_n1264 <= setup_half_length_n1259 & setup_light_length_n43;
    setup_half_length_n1265 <= setup_half_length_n1264 & setup_light_length_n42;
    setup_half_length_n1266 <= signed(resize(setup_half_length_n1263, 25)) - signed(resize(setup_half_length_n1265, 25));
    setup_half_length_n1267 <= unsigned(setup_half_length_n1266(24 downto 24));
    setup_half_length_n1268 <= signed(resize(setup_half_length_n1263, 25)) when setup_half_length_n1267(0) = '1' else setup_half_length_n1266;
    setup_half_length_n1269 <= unsigned(setup_half_length_n1268(22 downto 0));
    setup_half_length_n1270 <= setup_half_length_n1267 xor setup_light_length_n42;
    setup_half_length_n1271 <= setup_half_length_n1259 & setup_half_length_n1270;
    setup_half_length_n1275 <= setup_half_length_n1269 & setup_half_length_n1274_s12;
    setup_half_length_n1276 <= setup_half_length_n1271 & setup_light_length_n43;
    setup_half_length_n1277 <= setup_half_length_n1276 & setup_light_length_n42;
    -- setup.bump.unit_x
    setup_bump_unit_x_n2281_term <= resize(setup_bump_unit_x_n2216_s12, 26) xor (25 downto 0 => setup_bump_unit_x_n2277_s12(0));
    setup_bump_unit_x_n2281 <= resize(setup_bump_unit_x_n2280_s12, 26) + signed(setup_bump_unit_x_n2281_term) + setup_bump_unit_x_n2277_s12(0);
    setup_bump_unit_x_n2282 <= setup_bump_unit_x_n2281(23 downto 0);
    setup_bump_unit_x_n2283 <= unsigned(setup_bump_unit_x_n2282(23 downto 23));
    setup_bump_unit_x_n2284 <= setup_bump_unit_x_n2283 xor setup_light_length_n42;
    setup_bump_unit_x_n2285 <= unsigned(setup_bump_unit_x_n2282);
    setup_bump_unit_x_n2286 <= setup_bump_unit_x_n2285 & setup_light_length_n43;
    setup_bump_unit_x_n2287 <= signed(setup_bump_unit_x_n2286);
    setup_bump_unit_x_n2288_term <= resize(setup_bump_unit_x_n2216_s12, 26) xor (25 downto 0 => setup_bump_unit_x_n2284(0));
    setup_bump_unit_x_n2288 <= resize(setup_bump_unit_x_n2287, 26) + signed(setup_bump_unit_x_n2288_term) + setup_bump_unit_x_n2284(0);
    setup_bump_unit_x_n2289 <= setup_bump_unit_x_n2288(23 downto 0);
    setup_bump_unit_x_n2290 <= unsigned(setup_bump_unit_x_n2289(23 downto 23));
    setup_bump_unit_x_n2291 <= setup_bump_unit_x_n2290 xor setup_light_length_n42;
    setup_bump_unit_x_n2292 <= unsigned(setup_bump_unit_x_n2289);
    setup_bump_unit_x_n2293 <= setup_bump_unit_x_n2292 & setup_light_length_n43;
    setup_bump_unit_x_n2294 <= signed(setup_bump_unit_x_n2293);
    setup_bump_unit_x_n2396 <= setup_bump_unit_x_n2395_s12 & setup_bump_unit_x_n2284;
    setup_bump_unit_x_n2397 <= setup_bump_unit_x_n2396 & setup_bump_unit_x_n2291;
    -- setup.bump.unit_y
    setup_bump_unit_y_n2488_term <= resize(setup_bump_unit_x_n2216_s12, 26) xor (25 downto 0 => setup_bump_unit_y_n2484_s12(0));
    setup_bump_unit_y_n2488 <= resize(setup_bump_unit_y_n2487_s12, 26) + signed(setup_bump_unit_y_n2488_term) + setup_bump_unit_y_n2484_s12(0);
    setup_bump_unit_y_n2489 <= setup_bump_unit_y_n2488(23 downto 0);
    setup_bump_unit_y_n2490 <= unsigned(setup_bump_unit_y_n2489(23 downto 23));
    setup_bump_unit_y_n2491 <= setup_bump_unit_y_n2490 xor setup_light_length_n42;
    setup_bump_unit_y_n2492 <= unsigned(setup_bump_unit_y_n2489);
    setup_bump_unit_y_n2493 <= setup_bump_unit_y_n2492 & setup_light_length_n43;
    setup_bump_unit_y_n2494 <= signed(setup_bump_unit_y_n2493);
    setup_bump_unit_y_n2495_term <= resize(setup_bump_unit_x_n2216_s12, 26) xor (25 downto 0 => setup_bump_unit_y_n2491(0));
    setup_bump_unit_y_n2495 <= resize(setup_bump_unit_y_n2494, 26) + signed(setup_bump_unit_y_n2495_term) + setup_bump_unit_y_n2491(0);
    setup_bump_unit_y_n2496 <= setup_bump_unit_y_n2495(23 downto 0);
    setup_bump_unit_y_n2497 <= unsigned(setup_bump_unit_y_n2496(23 downto 23));
    setup_bump_unit_y_n2498 <= setup_bump_unit_y_n2497 xor setup_light_length_n42;
    setup_bump_unit_y_n2499 <= unsigned(setup_bump_unit_y_n2496);
    setup_bump_unit_y_n2500 <= setup_bump_unit_y_n2499 & setup_light_length_n43;
    setup_bump_unit_y_n2501 <= signed(setup_bump_unit_y_n2500);
    setup_bump_unit_y_n2603 <= setup_bump_unit_y_n2602_s12 & setup_bump_unit_y_n2491;
    setup_bump_unit_y_n2604 <= setup_bump_unit_y_n2603 & setup_bump_unit_y_n2498;
    -- setup.bump.unit_z
    setup_bump_unit_z_n2694_term <= resize(setup_bump_unit_x_n2216_s12, 26) xor (25 downto 0 => setup_bump_unit_z_n2690_s12(0));
    setup_bump_unit_z_n2694 <= resize(setup_bump_unit_z_n2693_s12, 26) + signed(setup_bump_unit_z_n2694_term) + setup_bump_unit_z_n2690_s12(0);
    setup_bump_unit_z_n2695 <= setup_bump_unit_z_n2694(23 downto 0);
    setup_bump_unit_z_n2696 <= unsigned(setup_bump_unit_z_n2695(23 downto 23));
    setup_bump_unit_z_n2697 <= setup_bump_unit_z_n2696 xor setup_light_length_n42;
    setup_bump_unit_z_n2698 <= unsigned(setup_bump_unit_z_n2695);
    setup_bump_unit_z_n2699 <= setup_bump_unit_z_n2698 & setup_light_length_n43;
    setup_bump_unit_z_n2700 <= signed(setup_bump_unit_z_n2699);
    setup_bump_unit_z_n2701_term <= resize(setup_bump_unit_x_n2216_s12, 26) xor (25 downto 0 => setup_bump_unit_z_n2697(0));
    setup_bump_unit_z_n2701 <= resize(setup_bump_unit_z_n2700, 26) + signed(setup_bump_unit_z_n2701_term) + setup_bump_unit_z_n2697(0);
    setup_bump_unit_z_n2702 <= setup_bump_unit_z_n2701(23 downto 0);
    setup_bump_unit_z_n2703 <= unsigned(setup_bump_unit_z_n2702(23 downto 23));
    setup_bump_unit_z_n2704 <= setup_bump_unit_z_n2703 xor setup_light_length_n42;
    setup_bump_unit_z_n2705 <= unsigned(setup_bump_unit_z_n2702);
    setup_bump_unit_z_n2706 <= setup_bump_unit_z_n2705 & setup_light_length_n43;
    setup_bump_unit_z_n2707 <= signed(setup_bump_unit_z_n2706);
    setup_bump_unit_z_n2809 <= setup_bump_unit_z_n2808_s12 & setup_bump_unit_z_n2697;
    setup_bump_unit_z_n2810 <= setup_bump_unit_z_n2809 & setup_bump_unit_z_n2704;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_length_n302_s13 <= setup_light_length_n302;
                setup_light_length_n306_s13 <= setup_light_length_n306;
                setup_light_length_n308_s13 <= setup_light_length_n308;
                setup_light_length_n317_s13 <= setup_light_length_n317_s12;
                setup_light_length_n327_s13 <= setup_light_length_n327_s12;
                setup_light_unit_x_n385_s13 <= setup_light_unit_x_n385_s12;
                setup_light_unit_x_n395_s13 <= setup_light_unit_x_n395_s12;
                setup_light_unit_x_n396_s13 <= setup_light_unit_x_n396_s12;
                setup_light_unit_x_n402_s13 <= setup_light_unit_x_n402_s12;
                setup_light_unit_x_n555_s13 <= setup_light_unit_x_n555_s12;
                setup_light_unit_x_n557_s13 <= setup_light_unit_x_n557_s12;
                setup_light_unit_y_n602_s13 <= setup_light_unit_y_n602_s12;
                setup_light_unit_y_n611_s13 <= setup_light_unit_y_n611_s12;
                setup_light_unit_y_n617_s13 <= setup_light_unit_y_n617_s12;
                setup_light_unit_y_n769_s13 <= setup_light_unit_y_n769_s12;
                setup_light_unit_y_n771_s13 <= setup_light_unit_y_n771_s12;
                setup_light_unit_z_n816_s13 <= setup_light_unit_z_n816_s12;
                setup_light_unit_z_n825_s13 <= setup_light_unit_z_n825_s12;
                setup_light_unit_z_n831_s13 <= setup_light_unit_z_n831_s12;
                setup_light_unit_z_n983_s13 <= setup_light_unit_z_n983_s12;
                setup_light_unit_z_n985_s13 <= setup_light_unit_z_n985_s12;
                setup_half_length_n1271_s13 <= setup_half_length_n1271;
                setup_half_length_n1275_s13 <= setup_half_length_n1275;
                setup_half_length_n1277_s13 <= setup_half_length_n1277;
                setup_half_length_n1286_s13 <= setup_half_length_n1286_s12;
                setup_half_unit_x_n1352_s13 <= setup_half_unit_x_n1352_s12;
                setup_half_unit_x_n1361_s13 <= setup_half_unit_x_n1361_s12;
                setup_half_unit_x_n1367_s13 <= setup_half_unit_x_n1367_s12;
                setup_half_unit_x_n1520_s13 <= setup_half_unit_x_n1520_s12;
                setup_half_unit_x_n1522_s13 <= setup_half_unit_x_n1522_s12;
                setup_half_unit_y_n1567_s13 <= setup_half_unit_y_n1567_s12;
                setup_half_unit_y_n1576_s13 <= setup_half_unit_y_n1576_s12;
                setup_half_unit_y_n1582_s13 <= setup_half_unit_y_n1582_s12;
                setup_half_unit_y_n1734_s13 <= setup_half_unit_y_n1734_s12;
                setup_half_unit_y_n1736_s13 <= setup_half_unit_y_n1736_s12;
                setup_half_unit_z_n1781_s13 <= setup_half_unit_z_n1781_s12;
                setup_half_unit_z_n1790_s13 <= setup_half_unit_z_n1790_s12;
                setup_half_unit_z_n1796_s13 <= setup_half_unit_z_n1796_s12;
                setup_half_unit_z_n1948_s13 <= setup_half_unit_z_n1948_s12;
                setup_half_unit_z_n1950_s13 <= setup_half_unit_z_n1950_s12;
                setup_bump_unit_x_n2216_s13 <= setup_bump_unit_x_n2216_s12;
                setup_bump_unit_x_n2291_s13 <= setup_bump_unit_x_n2291;
                setup_bump_unit_x_n2294_s13 <= setup_bump_unit_x_n2294;
                setup_bump_unit_x_n2397_s13 <= setup_bump_unit_x_n2397;
                setup_bump_unit_x_n2415_s13 <= setup_bump_unit_x_n2415_s12;
                setup_bump_unit_x_n2417_s13 <= setup_bump_unit_x_n2417_s12;
                setup_bump_unit_x_n2419_s13 <= setup_bump_unit_x_n2419_s12;
                setup_bump_unit_y_n2498_s13 <= setup_bump_unit_y_n2498;
                setup_bump_unit_y_n2501_s13 <= setup_bump_unit_y_n2501;
                setup_bump_unit_y_n2604_s13 <= setup_bump_unit_y_n2604;
                setup_bump_unit_y_n2621_s13 <= setup_bump_unit_y_n2621_s12;
                setup_bump_unit_y_n2623_s13 <= setup_bump_unit_y_n2623_s12;
                setup_bump_unit_y_n2625_s13 <= setup_bump_unit_y_n2625_s12;
                setup_bump_unit_z_n2704_s13 <= setup_bump_unit_z_n2704;
                setup_bump_unit_z_n2707_s13 <= setup_bump_unit_z_n2707;
                setup_bump_unit_z_n2810_s13 <= setup_bump_unit_z_n2810;
                setup_bump_unit_z_n2827_s13 <= setup_bump_unit_z_n2827_s12;
                setup_bump_unit_z_n2829_s13 <= setup_bump_unit_z_n2829_s12;
                setup_bump_unit_z_n2831_s13 <= setup_bump_unit_z_n2831_s12;
            end if;
            if rst = '1' then
                valid_s13 <= '0';
            elsif ce = '1' then
                valid_s13 <= valid_s12;
            end if;
        end if;
    end process;

    -- ---- stage 13 ----
    -- setup.light.length
    setup_light_length_n309 <= signed(resize(setup_light_length_n306_s13, 26)) - signed(resize(setup_light_length_n308_s13, 26));
    setup_light_length_n310 <= unsigned(setup_light_length_n309(25 downto 25));
    setup_light_length_n311 <= signed(resize(setup_light_length_n306_s13, 26)) when setup_light_length_n310(0) = '1' else setup_light_length_n309;
    setup_light_length_n312 <= unsigned(setup_light_length_n311(23 downto 0));
    setup_light_length_n313 <= setup_light_length_n310 xor setup_light_length_n42;
    setup_light_length_n314 <= setup_light_length_n302_s13 & setup_light_length_n313;
    setup_light_length_n318 <= setup_light_length_n312 & setup_light_length_n317_s13;
    setup_light_length_n319 <= setup_light_length_n314 & setup_light_length_n43;
    setup_light_length_n320 <= setup_light_length_n319 & setup_light_length_n42;
    setup_light_length_n321 <= signed(resize(setup_light_length_n318, 27)) - signed(resize(setup_light_length_n320, 27));
    setup_light_length_n322 <= unsigned(setup_light_length_n321(26 downto 26));
    setup_light_length_n323 <= signed(resize(setup_light_length_n318, 27)) when setup_light_length_n322(0) = '1' else setup_light_length_n321;
    setup_light_length_n324 <= unsigned(setup_light_length_n323(24 downto 0));
    setup_light_length_n325 <= setup_light_length_n322 xor setup_light_length_n42;
    setup_light_length_n326 <= setup_light_length_n314 & setup_light_length_n325;
    setup_light_length_n328 <= setup_light_length_n324 & setup_light_length_n327_s13;
    setup_light_length_n329 <= setup_light_length_n326 & setup_light_length_n43;
    setup_light_length_n330 <= setup_light_length_n329 & setup_light_length_n42;
    -- setup.half.length
    setup_half_length_n1278 <= signed(resize(setup_half_length_n1275_s13, 26)) - signed(resize(setup_half_length_n1277_s13, 26));
    setup_half_length_n1279 <= unsigned(setup_half_length_n1278(25 downto 25));
    setup_half_length_n1280 <= signed(resize(setup_half_length_n1275_s13, 26)) when setup_half_length_n1279(0) = '1' else setup_half_length_n1278;
    setup_half_length_n1281 <= unsigned(setup_half_length_n1280(23 downto 0));
    setup_half_length_n1282 <= setup_half_length_n1279 xor setup_light_length_n42;
    setup_half_length_n1283 <= setup_half_length_n1271_s13 & setup_half_length_n1282;
    setup_half_length_n1287 <= setup_half_length_n1281 & setup_half_length_n1286_s13;
    setup_half_length_n1288 <= setup_half_length_n1283 & setup_light_length_n43;
    setup_half_length_n1289 <= setup_half_length_n1288 & setup_light_length_n42;
    setup_half_length_n1290 <= signed(resize(setup_half_length_n1287, 27)) - signed(resize(setup_half_length_n1289, 27));
    setup_half_length_n1291 <= unsigned(setup_half_length_n1290(26 downto 26));
    setup_half_length_n1292 <= signed(resize(setup_half_length_n1287, 27)) when setup_half_length_n1291(0) = '1' else setup_half_length_n1290;
    setup_half_length_n1293 <= unsigned(setup_half_length_n1292(24 downto 0));
    setup_half_length_n1294 <= setup_half_length_n1291 xor setup_light_length_n42;
    setup_half_length_n1295 <= setup_half_length_n1283 & setup_half_length_n1294;
    setup_half_length_n1296 <= setup_half_length_n1293 & setup_light_length_n327_s13;
    setup_half_length_n1297 <= setup_half_length_n1295 & setup_light_length_n43;
    setup_half_length_n1298 <= setup_half_length_n1297 & setup_light_length_n42;
    -- setup.bump.unit_x
    setup_bump_unit_x_n2295_term <= resize(setup_bump_unit_x_n2216_s13, 26) xor (25 downto 0 => setup_bump_unit_x_n2291_s13(0));
    setup_bump_unit_x_n2295 <= resize(setup_bump_unit_x_n2294_s13, 26) + signed(setup_bump_unit_x_n2295_term) + setup_bump_unit_x_n2291_s13(0);
    setup_bump_unit_x_n2296 <= setup_bump_unit_x_n2295(23 downto 0);
    setup_bump_unit_x_n2297 <= unsigned(setup_bump_unit_x_n2296(23 downto 23));
    setup_bump_unit_x_n2298 <= setup_bump_unit_x_n2297 xor setup_light_length_n42;
    setup_bump_unit_x_n2299 <= unsigned(setup_bump_unit_x_n2296);
    setup_bump_unit_x_n2300 <= setup_bump_unit_x_n2299 & setup_light_length_n43;
    setup_bump_unit_x_n2301 <= signed(setup_bump_unit_x_n2300);
    setup_bump_unit_x_n2302_term <= resize(setup_bump_unit_x_n2216_s13, 26) xor (25 downto 0 => setup_bump_unit_x_n2298(0));
    setup_bump_unit_x_n2302 <= resize(setup_bump_unit_x_n2301, 26) + signed(setup_bump_unit_x_n2302_term) + setup_bump_unit_x_n2298(0);
    setup_bump_unit_x_n2303 <= setup_bump_unit_x_n2302(23 downto 0);
    setup_bump_unit_x_n2304 <= unsigned(setup_bump_unit_x_n2303(23 downto 23));
    setup_bump_unit_x_n2305 <= setup_bump_unit_x_n2304 xor setup_light_length_n42;
    setup_bump_unit_x_n2306 <= unsigned(setup_bump_unit_x_n2303);
    setup_bump_unit_x_n2307 <= setup_bump_unit_x_n2306 & setup_light_length_n43;
    setup_bump_unit_x_n2308 <= signed(setup_bump_unit_x_n2307);
    setup_bump_unit_x_n2398 <= setup_bump_unit_x_n2397_s13 & setup_bump_unit_x_n2298;
    setup_bump_unit_x_n2399 <= setup_bump_unit_x_n2398 & setup_bump_unit_x_n2305;
    -- setup.bump.unit_y
    setup_bump_unit_y_n2502_term <= resize(setup_bump_unit_x_n2216_s13, 26) xor (25 downto 0 => setup_bump_unit_y_n2498_s13(0));
    setup_bump_unit_y_n2502 <= resize(setup_bump_unit_y_n2501_s13, 26) + signed(setup_bump_unit_y_n2502_term) + setup_bump_unit_y_n2498_s13(0);
    setup_bump_unit_y_n2503 <= setup_bump_unit_y_n2502(23 downto 0);
    setup_bump_unit_y_n2504 <= unsigned(setup_bump_unit_y_n2503(23 downto 23));
    setup_bump_unit_y_n2505 <= setup_bump_unit_y_n2504 xor setup_light_length_n42;
    setup_bump_unit_y_n2506 <= unsigned(setup_bump_unit_y_n2503);
    setup_bump_unit_y_n2507 <= setup_bump_unit_y_n2506 & setup_light_length_n43;
    setup_bump_unit_y_n2508 <= signed(setup_bump_unit_y_n2507);
    setup_bump_unit_y_n2509_term <= resize(setup_bump_unit_x_n2216_s13, 26) xor (25 downto 0 => setup_bump_unit_y_n2505(0));
    setup_bump_unit_y_n2509 <= resize(setup_bump_unit_y_n2508, 26) + signed(setup_bump_unit_y_n2509_term) + setup_bump_unit_y_n2505(0);
    setup_bump_unit_y_n2510 <= setup_bump_unit_y_n2509(23 downto 0);
    setup_bump_unit_y_n2511 <= unsigned(setup_bump_unit_y_n2510(23 downto 23));
    setup_bump_unit_y_n2512 <= setup_bump_unit_y_n2511 xor setup_light_length_n42;
    setup_bump_unit_y_n2513 <= unsigned(setup_bump_unit_y_n2510);
    setup_bump_unit_y_n2514 <= setup_bump_unit_y_n2513 & setup_light_length_n43;
    setup_bump_unit_y_n2515 <= signed(setup_bump_unit_y_n2514);
    setup_bump_unit_y_n2605 <= setup_bump_unit_y_n2604_s13 & setup_bump_unit_y_n2505;
    setup_bump_unit_y_n2606 <= setup_bump_unit_y_n2605 & setup_bump_unit_y_n2512;
    -- setup.bump.unit_z
    setup_bump_unit_z_n2708_term <= resize(setup_bump_unit_x_n2216_s13, 26) xor (25 downto 0 => setup_bump_unit_z_n2704_s13(0));
    setup_bump_unit_z_n2708 <= resize(setup_bump_unit_z_n2707_s13, 26) + signed(setup_bump_unit_z_n2708_term) + setup_bump_unit_z_n2704_s13(0);
    setup_bump_unit_z_n2709 <= setup_bump_unit_z_n2708(23 downto 0);
    setup_bump_unit_z_n2710 <= unsigned(setup_bump_unit_z_n2709(23 downto 23));
    setup_bump_unit_z_n2711 <= setup_bump_unit_z_n2710 xor setup_light_length_n42;
    setup_bump_unit_z_n2712 <= unsigned(setup_bump_unit_z_n2709);
    setup_bump_unit_z_n2713 <= setup_bump_unit_z_n2712 & setup_light_length_n43;
    setup_bump_unit_z_n2714 <= signed(setup_bump_unit_z_n2713);
    setup_bump_unit_z_n2715_term <= resize(setup_bump_unit_x_n2216_s13, 26) xor (25 downto 0 => setup_bump_unit_z_n2711(0));
    setup_bump_unit_z_n2715 <= resize(setup_bump_unit_z_n2714, 26) + signed(setup_bump_unit_z_n2715_term) + setup_bump_unit_z_n2711(0);
    setup_bump_unit_z_n2716 <= setup_bump_unit_z_n2715(23 downto 0);
    setup_bump_unit_z_n2717 <= unsigned(setup_bump_unit_z_n2716(23 downto 23));
    setup_bump_unit_z_n2718 <= setup_bump_unit_z_n2717 xor setup_light_length_n42;
    setup_bump_unit_z_n2719 <= unsigned(setup_bump_unit_z_n2716);
    setup_bump_unit_z_n2720 <= setup_bump_unit_z_n2719 & setup_light_length_n43;
    setup_bump_unit_z_n2721 <= signed(setup_bump_unit_z_n2720);
    setup_bump_unit_z_n2811 <= setup_bump_unit_z_n2810_s13 & setup_bump_unit_z_n2711;
    setup_bump_unit_z_n2812 <= setup_bump_unit_z_n2811 & setup_bump_unit_z_n2718;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_length_n326_s14 <= setup_light_length_n326;
                setup_light_length_n328_s14 <= setup_light_length_n328;
                setup_light_length_n330_s14 <= setup_light_length_n330;
                setup_light_unit_x_n385_s14 <= setup_light_unit_x_n385_s13;
                setup_light_unit_x_n395_s14 <= setup_light_unit_x_n395_s13;
                setup_light_unit_x_n396_s14 <= setup_light_unit_x_n396_s13;
                setup_light_unit_x_n402_s14 <= setup_light_unit_x_n402_s13;
                setup_light_unit_x_n555_s14 <= setup_light_unit_x_n555_s13;
                setup_light_unit_x_n557_s14 <= setup_light_unit_x_n557_s13;
                setup_light_unit_y_n602_s14 <= setup_light_unit_y_n602_s13;
                setup_light_unit_y_n611_s14 <= setup_light_unit_y_n611_s13;
                setup_light_unit_y_n617_s14 <= setup_light_unit_y_n617_s13;
                setup_light_unit_y_n769_s14 <= setup_light_unit_y_n769_s13;
                setup_light_unit_y_n771_s14 <= setup_light_unit_y_n771_s13;
                setup_light_unit_z_n816_s14 <= setup_light_unit_z_n816_s13;
                setup_light_unit_z_n825_s14 <= setup_light_unit_z_n825_s13;
                setup_light_unit_z_n831_s14 <= setup_light_unit_z_n831_s13;
                setup_light_unit_z_n983_s14 <= setup_light_unit_z_n983_s13;
                setup_light_unit_z_n985_s14 <= setup_light_unit_z_n985_s13;
                setup_half_length_n1295_s14 <= setup_half_length_n1295;
                setup_half_length_n1296_s14 <= setup_half_length_n1296;
                setup_half_length_n1298_s14 <= setup_half_length_n1298;
                setup_half_unit_x_n1352_s14 <= setup_half_unit_x_n1352_s13;
                setup_half_unit_x_n1361_s14 <= setup_half_unit_x_n1361_s13;
                setup_half_unit_x_n1367_s14 <= setup_half_unit_x_n1367_s13;
                setup_half_unit_x_n1520_s14 <= setup_half_unit_x_n1520_s13;
                setup_half_unit_x_n1522_s14 <= setup_half_unit_x_n1522_s13;
                setup_half_unit_y_n1567_s14 <= setup_half_unit_y_n1567_s13;
                setup_half_unit_y_n1576_s14 <= setup_half_unit_y_n1576_s13;
                setup_half_unit_y_n1582_s14 <= setup_half_unit_y_n1582_s13;
                setup_half_unit_y_n1734_s14 <= setup_half_unit_y_n1734_s13;
                setup_half_unit_y_n1736_s14 <= setup_half_unit_y_n1736_s13;
                setup_half_unit_z_n1781_s14 <= setup_half_unit_z_n1781_s13;
                setup_half_unit_z_n1790_s14 <= setup_half_unit_z_n1790_s13;
                setup_half_unit_z_n1796_s14 <= setup_half_unit_z_n1796_s13;
                setup_half_unit_z_n1948_s14 <= setup_half_unit_z_n1948_s13;
                setup_half_unit_z_n1950_s14 <= setup_half_unit_z_n1950_s13;
                setup_bump_unit_x_n2216_s14 <= setup_bump_unit_x_n2216_s13;
                setup_bump_unit_x_n2305_s14 <= setup_bump_unit_x_n2305;
                setup_bump_unit_x_n2308_s14 <= setup_bump_unit_x_n2308;
                setup_bump_unit_x_n2399_s14 <= setup_bump_unit_x_n2399;
                setup_bump_unit_x_n2415_s14 <= setup_bump_unit_x_n2415_s13;
                setup_bump_unit_x_n2417_s14 <= setup_bump_unit_x_n2417_s13;
                setup_bump_unit_x_n2419_s14 <= setup_bump_unit_x_n2419_s13;
                setup_bump_unit_y_n2512_s14 <= setup_bump_unit_y_n2512;
                setup_bump_unit_y_n2515_s14 <= setup_bump_unit_y_n2515;
                setup_bump_unit_y_n2606_s14 <= setup_bump_unit_y_n2606;
                setup_bump_unit_y_n2621_s14 <= setup_bump_unit_y_n2621_s13;
                setup_bump_unit_y_n2623_s14 <= setup_bump_unit_y_n2623_s13;
                setup_bump_unit_y_n2625_s14 <= setup_bump_unit_y_n2625_s13;
                setup_bump_unit_z_n2718_s14 <= setup_bump_unit_z_n2718;
                setup_bump_unit_z_n2721_s14 <= setup_bump_unit_z_n2721;
                setup_bump_unit_z_n2812_s14 <= setup_bump_unit_z_n2812;
                setup_bump_unit_z_n2827_s14 <= setup_bump_unit_z_n2827_s13;
                setup_bump_unit_z_n2829_s14 <= setup_bump_unit_z_n2829_s13;
                setup_bump_unit_z_n2831_s14 <= setup_bump_unit_z_n2831_s13;
            end if;
            if rst = '1' then
                valid_s14 <= '0';
            elsif ce = '1' then
                valid_s14 <= valid_s13;
            end if;
        end if;
    end process;

    -- ---- stage 14 ----
    -- setup.light.length
    setup_light_length_n331 <= signed(resize(setup_light_length_n328_s14, 28)) - signed(resize(setup_light_length_n330_s14, 28));
    setup_light_length_n332 <= unsigned(setup_light_length_n331(27 downto 27));
    setup_light_length_n333 <= signed(resize(setup_light_length_n328_s14, 28)) when setup_light_length_n332(0) = '1' else setup_light_length_n331;
    setup_light_length_n334 <= unsigned(setup_light_length_n333(25 downto 0));
    setup_light_length_n335 <= setup_light_length_n332 xor setup_light_length_n42;
    setup_light_length_n336 <= setup_light_length_n326_s14 & setup_light_length_n335;
    setup_light_length_n337 <= "1" when setup_light_length_n334 = resize(setup_light_length_n43, 26) else "0";
    setup_light_length_n338 <= setup_light_length_n337 xor setup_light_length_n42;
    setup_light_length_n339 <= setup_light_length_n336 & setup_light_length_n338;
    setup_light_length_n340 <= setup_light_length_n339;
    -- setup.half.length
    setup_half_length_n1299 <= signed(resize(setup_half_length_n1296_s14, 28)) - signed(resize(setup_half_length_n1298_s14, 28));
    setup_half_length_n1300 <= unsigned(setup_half_length_n1299(27 downto 27));
    setup_half_length_n1301 <= signed(resize(setup_half_length_n1296_s14, 28)) when setup_half_length_n1300(0) = '1' else setup_half_length_n1299;
    setup_half_length_n1302 <= unsigned(setup_half_length_n1301(25 downto 0));
    setup_half_length_n1303 <= setup_half_length_n1300 xor setup_light_length_n42;
    setup_half_length_n1304 <= setup_half_length_n1295_s14 & setup_half_length_n1303;
    setup_half_length_n1305 <= "1" when setup_half_length_n1302 = resize(setup_light_length_n43, 26) else "0";
    setup_half_length_n1306 <= setup_half_length_n1305 xor setup_light_length_n42;
    setup_half_length_n1307 <= setup_half_length_n1304 & setup_half_length_n1306;
    setup_half_length_n1308 <= setup_half_length_n1307;
    -- setup.bump.unit_x
    setup_bump_unit_x_n2309_term <= resize(setup_bump_unit_x_n2216_s14, 26) xor (25 downto 0 => setup_bump_unit_x_n2305_s14(0));
    setup_bump_unit_x_n2309 <= resize(setup_bump_unit_x_n2308_s14, 26) + signed(setup_bump_unit_x_n2309_term) + setup_bump_unit_x_n2305_s14(0);
    setup_bump_unit_x_n2310 <= setup_bump_unit_x_n2309(23 downto 0);
    setup_bump_unit_x_n2311 <= unsigned(setup_bump_unit_x_n2310(23 downto 23));
    setup_bump_unit_x_n2312 <= setup_bump_unit_x_n2311 xor setup_light_length_n42;
    setup_bump_unit_x_n2313 <= unsigned(setup_bump_unit_x_n2310);
    setup_bump_unit_x_n2314 <= setup_bump_unit_x_n2313 & setup_light_length_n43;
    setup_bump_unit_x_n2315 <= signed(setup_bump_unit_x_n2314);
    setup_bump_unit_x_n2316_term <= resize(setup_bump_unit_x_n2216_s14, 26) xor (25 downto 0 => setup_bump_unit_x_n2312(0));
    setup_bump_unit_x_n2316 <= resize(setup_bump_unit_x_n2315, 26) + signed(setup_bump_unit_x_n2316_term) + setup_bump_unit_x_n2312(0);
    setup_bump_unit_x_n2317 <= setup_bump_unit_x_n2316(23 downto 0);
    setup_bump_unit_x_n2318 <= unsigned(setup_bump_unit_x_n2317(23 downto 23));
    setup_bump_unit_x_n2319 <= setup_bump_unit_x_n2318 xor setup_light_length_n42;
    setup_bump_unit_x_n2320 <= unsigned(setup_bump_unit_x_n2317);
    setup_bump_unit_x_n2321 <= setup_bump_unit_x_n2320 & setup_light_length_n43;
    setup_bump_unit_x_n2322 <= signed(setup_bump_unit_x_n2321);
    setup_bump_unit_x_n2400 <= setup_bump_unit_x_n2399_s14 & setup_bump_unit_x_n2312;
    setup_bump_unit_x_n2401 <= setup_bump_unit_x_n2400 & setup_bump_unit_x_n2319;
    -- setup.bump.unit_y
    setup_bump_unit_y_n2516_term <= resize(setup_bump_unit_x_n2216_s14, 26) xor (25 downto 0 => setup_bump_unit_y_n2512_s14(0));
    setup_bump_unit_y_n2516 <= resize(setup_bump_unit_y_n2515_s14, 26) + signed(setup_bump_unit_y_n2516_term) + setup_bump_unit_y_n2512_s14(0);
    setup_bump_unit_y_n2517 <= setup_bump_unit_y_n2516(23 downto 0);
    setup_bump_unit_y_n2518 <= unsigned(setup_bump_unit_y_n2517(23 downto 23));
    setup_bump_unit_y_n2519 <= setup_bump_unit_y_n2518 xor setup_light_length_n42;
    setup_bump_unit_y_n2520 <= unsigned(setup_bump_unit_y_n2517);
    setup_bump_unit_y_n2521 <= setup_bump_unit_y_n2520 & setup_light_length_n43;
    setup_bump_unit_y_n2522 <= signed(setup_bump_unit_y_n2521);
    setup_bump_unit_y_n2523_term <= resize(setup_bump_unit_x_n2216_s14, 26) xor (25 downto 0 => setup_bump_unit_y_n2519(0));
    setup_bump_unit_y_n2523 <= resize(setup_bump_unit_y_n2522, 26) + signed(setup_bump_unit_y_n2523_term) + setup_bump_unit_y_n2519(0);
    setup_bump_unit_y_n2524 <= setup_bump_unit_y_n2523(23 downto 0);
    setup_bump_unit_y_n2525 <= unsigned(setup_bump_unit_y_n2524(23 downto 23));
    setup_bump_unit_y_n2526 <= setup_bump_unit_y_n2525 xor setup_light_length_n42;
    setup_bump_unit_y_n2527 <= unsigned(setup_bump_unit_y_n2524);
    setup_bump_unit_y_n2528 <= setup_bump_unit_y_n2527 & setup_light_length_n43;
    setup_bump_unit_y_n2529 <= signed(setup_bump_unit_y_n2528);
    setup_bump_unit_y_n2607 <= setup_bump_unit_y_n2606_s14 & setup_bump_unit_y_n2519;
    setup_bump_unit_y_n2608 <= setup_bump_unit_y_n2607 & setup_bump_unit_y_n2526;
    -- setup.bump.unit_z
    setup_bump_unit_z_n2722_term <= resize(setup_bump_unit_x_n2216_s14, 26) xor (25 downto 0 => setup_bump_unit_z_n2718_s14(0));
    setup_bump_unit_z_n2722 <= resize(setup_bump_unit_z_n2721_s14, 26) + signed(setup_bump_unit_z_n2722_term) + setup_bump_unit_z_n2718_s14(0);
    setup_bump_unit_z_n2723 <= setup_bump_unit_z_n2722(23 downto 0);
    setup_bump_unit_z_n2724 <= unsigned(setup_bump_unit_z_n2723(23 downto 23));
    setup_bump_unit_z_n2725 <= setup_bump_unit_z_n2724 xor setup_light_length_n42;
    setup_bump_unit_z_n2726 <= unsigned(setup_bump_unit_z_n2723);
    setup_bump_unit_z_n2727 <= setup_bump_unit_z_n2726 & setup_light_length_n43;
    setup_bump_unit_z_n2728 <= signed(setup_bump_unit_z_n2727);
    setup_bump_unit_z_n2729_term <= resize(setup_bump_unit_x_n2216_s14, 26) xor (25 downto 0 => setup_bump_unit_z_n2725(0));
    setup_bump_unit_z_n2729 <= resize(setup_bump_unit_z_n2728, 26) + signed(setup_bump_unit_z_n2729_term) + setup_bump_unit_z_n2725(0);
    setup_bump_unit_z_n2730 <= setup_bump_unit_z_n2729(23 downto 0);
    setup_bump_unit_z_n2731 <= unsigned(setup_bump_unit_z_n2730(23 downto 23));
    setup_bump_unit_z_n2732 <= setup_bump_unit_z_n2731 xor setup_light_length_n42;
    setup_bump_unit_z_n2733 <= unsigned(setup_bump_unit_z_n2730);
    setup_bump_unit_z_n2734 <= setup_bump_unit_z_n2733 & setup_light_length_n43;
    setup_bump_unit_z_n2735 <= signed(setup_bump_unit_z_n2734);
    setup_bump_unit_z_n2813 <= setup_bump_unit_z_n2812_s14 & setup_bump_unit_z_n2725;
    setup_bump_unit_z_n2814 <= setup_bump_unit_z_n2813 & setup_bump_unit_z_n2732;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_length_n340_s15 <= setup_light_length_n340;
                setup_light_unit_x_n385_s15 <= setup_light_unit_x_n385_s14;
                setup_light_unit_x_n395_s15 <= setup_light_unit_x_n395_s14;
                setup_light_unit_x_n396_s15 <= setup_light_unit_x_n396_s14;
                setup_light_unit_x_n402_s15 <= setup_light_unit_x_n402_s14;
                setup_light_unit_x_n555_s15 <= setup_light_unit_x_n555_s14;
                setup_light_unit_x_n557_s15 <= setup_light_unit_x_n557_s14;
                setup_light_unit_y_n602_s15 <= setup_light_unit_y_n602_s14;
                setup_light_unit_y_n611_s15 <= setup_light_unit_y_n611_s14;
                setup_light_unit_y_n617_s15 <= setup_light_unit_y_n617_s14;
                setup_light_unit_y_n769_s15 <= setup_light_unit_y_n769_s14;
                setup_light_unit_y_n771_s15 <= setup_light_unit_y_n771_s14;
                setup_light_unit_z_n816_s15 <= setup_light_unit_z_n816_s14;
                setup_light_unit_z_n825_s15 <= setup_light_unit_z_n825_s14;
                setup_light_unit_z_n831_s15 <= setup_light_unit_z_n831_s14;
                setup_light_unit_z_n983_s15 <= setup_light_unit_z_n983_s14;
                setup_light_unit_z_n985_s15 <= setup_light_unit_z_n985_s14;
                setup_half_length_n1308_s15 <= setup_half_length_n1308;
                setup_half_unit_x_n1352_s15 <= setup_half_unit_x_n1352_s14;
                setup_half_unit_x_n1361_s15 <= setup_half_unit_x_n1361_s14;
                setup_half_unit_x_n1367_s15 <= setup_half_unit_x_n1367_s14;
                setup_half_unit_x_n1520_s15 <= setup_half_unit_x_n1520_s14;
                setup_half_unit_x_n1522_s15 <= setup_half_unit_x_n1522_s14;
                setup_half_unit_y_n1567_s15 <= setup_half_unit_y_n1567_s14;
                setup_half_unit_y_n1576_s15 <= setup_half_unit_y_n1576_s14;
                setup_half_unit_y_n1582_s15 <= setup_half_unit_y_n1582_s14;
                setup_half_unit_y_n1734_s15 <= setup_half_unit_y_n1734_s14;
                setup_half_unit_y_n1736_s15 <= setup_half_unit_y_n1736_s14;
                setup_half_unit_z_n1781_s15 <= setup_half_unit_z_n1781_s14;
                setup_half_unit_z_n1790_s15 <= setup_half_unit_z_n1790_s14;
                setup_half_unit_z_n1796_s15 <= setup_half_unit_z_n1796_s14;
                setup_half_unit_z_n1948_s15 <= setup_half_unit_z_n1948_s14;
                setup_half_unit_z_n1950_s15 <= setup_half_unit_z_n1950_s14;
                setup_bump_unit_x_n2216_s15 <= setup_bump_unit_x_n2216_s14;
                setup_bump_unit_x_n2319_s15 <= setup_bump_unit_x_n2319;
                setup_bump_unit_x_n2322_s15 <= setup_bump_unit_x_n2322;
                setup_bump_unit_x_n2401_s15 <= setup_bump_unit_x_n2401;
                setup_bump_unit_x_n2415_s15 <= setup_bump_unit_x_n2415_s14;
                setup_bump_unit_x_n2417_s15 <= setup_bump_unit_x_n2417_s14;
                setup_bump_unit_x_n2419_s15 <= setup_bump_unit_x_n2419_s14;
                setup_bump_unit_y_n2526_s15 <= setup_bump_unit_y_n2526;
                setup_bump_unit_y_n2529_s15 <= setup_bump_unit_y_n2529;
                setup_bump_unit_y_n2608_s15 <= setup_bump_unit_y_n2608;
                setup_bump_unit_y_n2621_s15 <= setup_bump_unit_y_n2621_s14;
                setup_bump_unit_y_n2623_s15 <= setup_bump_unit_y_n2623_s14;
                setup_bump_unit_y_n2625_s15 <= setup_bump_unit_y_n2625_s14;
                setup_bump_unit_z_n2732_s15 <= setup_bump_unit_z_n2732;
                setup_bump_unit_z_n2735_s15 <= setup_bump_unit_z_n2735;
                setup_bump_unit_z_n2814_s15 <= setup_bump_unit_z_n2814;
                setup_bump_unit_z_n2827_s15 <= setup_bump_unit_z_n2827_s14;
                setup_bump_unit_z_n2829_s15 <= setup_bump_unit_z_n2829_s14;
                setup_bump_unit_z_n2831_s15 <= setup_bump_unit_z_n2831_s14;
            end if;
            if rst = '1' then
                valid_s15 <= '0';
            elsif ce = '1' then
                valid_s15 <= valid_s14;
            end if;
        end if;
    end process;

    -- ---- stage 15 ----
    -- setup.light.length
    setup_light_length_length_sum <= resize(setup_light_length_n340_s15, 27) + 27x"0000002";
    setup_light_length_length_cut <= setup_light_length_length_sum(26 downto 2);
    setup_light_length_length_over <= "1" when (or setup_light_length_length_cut(24 downto 23)) = '1' else "0";
    setup_light_length_length <= 23x"7fffff" when setup_light_length_length_over(0) = '1' else setup_light_length_length_cut(22 downto 0);
    -- setup.light.unit_x
    setup_light_unit_x_n344 <= setup_light_length_length;
    setup_light_unit_x_n386 <= "1" when resize(setup_light_unit_x_n385_s15, 23) < setup_light_unit_x_n344 else "0";
    setup_light_unit_x_n387 <= setup_light_unit_x_n386 xor setup_light_length_n42;
    setup_light_unit_x_n397_term <= resize(setup_light_unit_x_n344, 26) xor (25 downto 0 => setup_light_unit_x_n396_s15(0));
    setup_light_unit_x_n397 <= resize(setup_light_unit_x_n395_s15, 26) + signed(setup_light_unit_x_n397_term) + setup_light_unit_x_n396_s15(0);
    setup_light_unit_x_n398 <= setup_light_unit_x_n397(23 downto 0);
    setup_light_unit_x_n399 <= unsigned(setup_light_unit_x_n398(23 downto 23));
    setup_light_unit_x_n400 <= setup_light_unit_x_n399 xor setup_light_length_n42;
    setup_light_unit_x_n401 <= unsigned(setup_light_unit_x_n398);
    setup_light_unit_x_n403 <= setup_light_unit_x_n401 & setup_light_unit_x_n402_s15;
    setup_light_unit_x_n404 <= signed(setup_light_unit_x_n403);
    setup_light_unit_x_n552 <= "1" when setup_light_length_length = shift_left(resize(setup_light_length_n43, 23), 18) else "0";
    setup_light_unit_x_n553 <= setup_light_unit_x_n387 or setup_light_unit_x_n552;
    -- setup.light.unit_y
    setup_light_unit_y_n603 <= "1" when resize(setup_light_unit_y_n602_s15, 23) < setup_light_unit_x_n344 else "0";
    setup_light_unit_y_n604 <= setup_light_unit_y_n603 xor setup_light_length_n42;
    setup_light_unit_y_n612_term <= resize(setup_light_unit_x_n344, 26) xor (25 downto 0 => setup_light_unit_x_n396_s15(0));
    setup_light_unit_y_n612 <= resize(setup_light_unit_y_n611_s15, 26) + signed(setup_light_unit_y_n612_term) + setup_light_unit_x_n396_s15(0);
    setup_light_unit_y_n613 <= setup_light_unit_y_n612(23 downto 0);
    setup_light_unit_y_n614 <= unsigned(setup_light_unit_y_n613(23 downto 23));
    setup_light_unit_y_n615 <= setup_light_unit_y_n614 xor setup_light_length_n42;
    setup_light_unit_y_n616 <= unsigned(setup_light_unit_y_n613);
    setup_light_unit_y_n618 <= setup_light_unit_y_n616 & setup_light_unit_y_n617_s15;
    setup_light_unit_y_n619 <= signed(setup_light_unit_y_n618);
    setup_light_unit_y_n767 <= setup_light_unit_y_n604 or setup_light_unit_x_n552;
    -- setup.light.unit_z
    setup_light_unit_z_n817 <= "1" when resize(setup_light_unit_z_n816_s15, 23) < setup_light_unit_x_n344 else "0";
    setup_light_unit_z_n818 <= setup_light_unit_z_n817 xor setup_light_length_n42;
    setup_light_unit_z_n826_term <= resize(setup_light_unit_x_n344, 26) xor (25 downto 0 => setup_light_unit_x_n396_s15(0));
    setup_light_unit_z_n826 <= resize(setup_light_unit_z_n825_s15, 26) + signed(setup_light_unit_z_n826_term) + setup_light_unit_x_n396_s15(0);
    setup_light_unit_z_n827 <= setup_light_unit_z_n826(23 downto 0);
    setup_light_unit_z_n828 <= unsigned(setup_light_unit_z_n827(23 downto 23));
    setup_light_unit_z_n829 <= setup_light_unit_z_n828 xor setup_light_length_n42;
    setup_light_unit_z_n830 <= unsigned(setup_light_unit_z_n827);
    setup_light_unit_z_n832 <= setup_light_unit_z_n830 & setup_light_unit_z_n831_s15;
    setup_light_unit_z_n833 <= signed(setup_light_unit_z_n832);
    setup_light_unit_z_n981 <= setup_light_unit_z_n818 or setup_light_unit_x_n552;
    -- setup.half.length
    setup_half_length_length_sum <= resize(setup_half_length_n1308_s15, 27) + 27x"0000002";
    setup_half_length_length_cut <= setup_half_length_length_sum(26 downto 2);
    setup_half_length_length_over <= "1" when (or setup_half_length_length_cut(24 downto 23)) = '1' else "0";
    setup_half_length_length <= 23x"7fffff" when setup_half_length_length_over(0) = '1' else setup_half_length_length_cut(22 downto 0);
    -- setup.half.unit_x
    setup_half_unit_x_n1311 <= setup_half_length_length;
    setup_half_unit_x_n1353 <= "1" when resize(setup_half_unit_x_n1352_s15, 23) < setup_half_unit_x_n1311 else "0";
    setup_half_unit_x_n1354 <= setup_half_unit_x_n1353 xor setup_light_length_n42;
    setup_half_unit_x_n1362_term <= resize(setup_half_unit_x_n1311, 26) xor (25 downto 0 => setup_light_unit_x_n396_s15(0));
    setup_half_unit_x_n1362 <= resize(setup_half_unit_x_n1361_s15, 26) + signed(setup_half_unit_x_n1362_term) + setup_light_unit_x_n396_s15(0);
    setup_half_unit_x_n1363 <= setup_half_unit_x_n1362(23 downto 0);
    setup_half_unit_x_n1364 <= unsigned(setup_half_unit_x_n1363(23 downto 23));
    setup_half_unit_x_n1365 <= setup_half_unit_x_n1364 xor setup_light_length_n42;
    setup_half_unit_x_n1366 <= unsigned(setup_half_unit_x_n1363);
    setup_half_unit_x_n1368 <= setup_half_unit_x_n1366 & setup_half_unit_x_n1367_s15;
    setup_half_unit_x_n1369 <= signed(setup_half_unit_x_n1368);
    setup_half_unit_x_n1517 <= "1" when setup_half_length_length = shift_left(resize(setup_light_length_n43, 23), 18) else "0";
    setup_half_unit_x_n1518 <= setup_half_unit_x_n1354 or setup_half_unit_x_n1517;
    -- setup.half.unit_y
    setup_half_unit_y_n1568 <= "1" when resize(setup_half_unit_y_n1567_s15, 23) < setup_half_unit_x_n1311 else "0";
    setup_half_unit_y_n1569 <= setup_half_unit_y_n1568 xor setup_light_length_n42;
    setup_half_unit_y_n1577_term <= resize(setup_half_unit_x_n1311, 26) xor (25 downto 0 => setup_light_unit_x_n396_s15(0));
    setup_half_unit_y_n1577 <= resize(setup_half_unit_y_n1576_s15, 26) + signed(setup_half_unit_y_n1577_term) + setup_light_unit_x_n396_s15(0);
    setup_half_unit_y_n1578 <= setup_half_unit_y_n1577(23 downto 0);
    setup_half_unit_y_n1579 <= unsigned(setup_half_unit_y_n1578(23 downto 23));
    setup_half_unit_y_n1580 <= setup_half_unit_y_n1579 xor setup_light_length_n42;
    setup_half_unit_y_n1581 <= unsigned(setup_half_unit_y_n1578);
    setup_half_unit_y_n1583 <= setup_half_unit_y_n1581 & setup_half_unit_y_n1582_s15;
    setup_half_unit_y_n1584 <= signed(setup_half_unit_y_n1583);
    setup_half_unit_y_n1732 <= setup_half_unit_y_n1569 or setup_half_unit_x_n1517;
    -- setup.half.unit_z
    setup_half_unit_z_n1782 <= "1" when resize(setup_half_unit_z_n1781_s15, 23) < setup_half_unit_x_n1311 else "0";
    setup_half_unit_z_n1783 <= setup_half_unit_z_n1782 xor setup_light_length_n42;
    setup_half_unit_z_n1791_term <= resize(setup_half_unit_x_n1311, 26) xor (25 downto 0 => setup_light_unit_x_n396_s15(0));
    setup_half_unit_z_n1791 <= resize(setup_half_unit_z_n1790_s15, 26) + signed(setup_half_unit_z_n1791_term) + setup_light_unit_x_n396_s15(0);
    setup_half_unit_z_n1792 <= setup_half_unit_z_n1791(23 downto 0);
    setup_half_unit_z_n1793 <= unsigned(setup_half_unit_z_n1792(23 downto 23));
    setup_half_unit_z_n1794 <= setup_half_unit_z_n1793 xor setup_light_length_n42;
    setup_half_unit_z_n1795 <= unsigned(setup_half_unit_z_n1792);
    setup_half_unit_z_n1797 <= setup_half_unit_z_n1795 & setup_half_unit_z_n1796_s15;
    setup_half_unit_z_n1798 <= signed(setup_half_unit_z_n1797);
    setup_half_unit_z_n1946 <= setup_half_unit_z_n1783 or setup_half_unit_x_n1517;
    -- setup.bump.unit_x
    setup_bump_unit_x_n2323_term <= resize(setup_bump_unit_x_n2216_s15, 26) xor (25 downto 0 => setup_bump_unit_x_n2319_s15(0));
    setup_bump_unit_x_n2323 <= resize(setup_bump_unit_x_n2322_s15, 26) + signed(setup_bump_unit_x_n2323_term) + setup_bump_unit_x_n2319_s15(0);
    setup_bump_unit_x_n2324 <= setup_bump_unit_x_n2323(23 downto 0);
    setup_bump_unit_x_n2325 <= unsigned(setup_bump_unit_x_n2324(23 downto 23));
    setup_bump_unit_x_n2326 <= setup_bump_unit_x_n2325 xor setup_light_length_n42;
    setup_bump_unit_x_n2327 <= unsigned(setup_bump_unit_x_n2324);
    setup_bump_unit_x_n2328 <= setup_bump_unit_x_n2327 & setup_light_length_n43;
    setup_bump_unit_x_n2329 <= signed(setup_bump_unit_x_n2328);
    setup_bump_unit_x_n2330_term <= resize(setup_bump_unit_x_n2216_s15, 26) xor (25 downto 0 => setup_bump_unit_x_n2326(0));
    setup_bump_unit_x_n2330 <= resize(setup_bump_unit_x_n2329, 26) + signed(setup_bump_unit_x_n2330_term) + setup_bump_unit_x_n2326(0);
    setup_bump_unit_x_n2331 <= setup_bump_unit_x_n2330(23 downto 0);
    setup_bump_unit_x_n2332 <= unsigned(setup_bump_unit_x_n2331(23 downto 23));
    setup_bump_unit_x_n2333 <= setup_bump_unit_x_n2332 xor setup_light_length_n42;
    setup_bump_unit_x_n2334 <= unsigned(setup_bump_unit_x_n2331);
    setup_bump_unit_x_n2335 <= setup_bump_unit_x_n2334 & setup_light_length_n43;
    setup_bump_unit_x_n2336 <= signed(setup_bump_unit_x_n2335);
    setup_bump_unit_x_n2402 <= setup_bump_unit_x_n2401_s15 & setup_bump_unit_x_n2326;
    setup_bump_unit_x_n2403 <= setup_bump_unit_x_n2402 & setup_bump_unit_x_n2333;
    -- setup.bump.unit_y
    setup_bump_unit_y_n2530_term <= resize(setup_bump_unit_x_n2216_s15, 26) xor (25 downto 0 => setup_bump_unit_y_n2526_s15(0));
    setup_bump_unit_y_n2530 <= resize(setup_bump_unit_y_n2529_s15, 26) + signed(setup_bump_unit_y_n2530_term) + setup_bump_unit_y_n2526_s15(0);
    setup_bump_unit_y_n2531 <= setup_bump_unit_y_n2530(23 downto 0);
    setup_bump_unit_y_n2532 <= unsigned(setup_bump_unit_y_n2531(23 downto 23));
    setup_bump_unit_y_n2533 <= setup_bump_unit_y_n2532 xor setup_light_length_n42;
    setup_bump_unit_y_n2534 <= unsigned(setup_bump_unit_y_n2531);
    setup_bump_unit_y_n2535 <= setup_bump_unit_y_n2534 & setup_light_length_n43;
    setup_bump_unit_y_n2536 <= signed(setup_bump_unit_y_n2535);
    setup_bump_unit_y_n2537_term <= resize(setup_bump_unit_x_n2216_s15, 26) xor (25 downto 0 => setup_bump_unit_y_n2533(0));
    setup_bump_unit_y_n2537 <= resize(setup_bump_unit_y_n2536, 26) + signed(setup_bump_unit_y_n2537_term) + setup_bump_unit_y_n2533(0);
    setup_bump_unit_y_n2538 <= setup_bump_unit_y_n2537(23 downto 0);
    setup_bump_unit_y_n2539 <= unsigned(setup_bump_unit_y_n2538(23 downto 23));
    setup_bump_unit_y_n2540 <= setup_bump_unit_y_n2539 xor setup_light_length_n42;
    setup_bump_unit_y_n2541 <= unsigned(setup_bump_unit_y_n2538);
    setup_bump_unit_y_n2542 <= setup_bump_unit_y_n2541 & setup_light_length_n43;
    setup_bump_unit_y_n2543 <= signed(setup_bump_unit_y_n2542);
    setup_bump_unit_y_n2609 <= setup_bump_unit_y_n2608_s15 & setup_bump_unit_y_n2533;
    setup_bump_unit_y_n2610 <= setup_bump_unit_y_n2609 & setup_bump_unit_y_n2540;
    -- setup.bump.unit_z
    setup_bump_unit_z_n2736_term <= resize(setup_bump_unit_x_n2216_s15, 26) xor (25 downto 0 => setup_bump_unit_z_n2732_s15(0));
    setup_bump_unit_z_n2736 <= resize(setup_bump_unit_z_n2735_s15, 26) + signed(setup_bump_unit_z_n2736_term) + setup_bump_unit_z_n2732_s15(0);
    setup_bump_unit_z_n2737 <= setup_bump_unit_z_n2736(23 downto 0);
    setup_bump_unit_z_n2738 <= unsigned(setup_bump_unit_z_n2737(23 downto 23));
    setup_bump_unit_z_n2739 <= setup_bump_unit_z_n2738 xor setup_light_length_n42;
    setup_bump_unit_z_n2740 <= unsigned(setup_bump_unit_z_n2737);
    setup_bump_unit_z_n2741 <= setup_bump_unit_z_n2740 & setup_light_length_n43;
    setup_bump_unit_z_n2742 <= signed(setup_bump_unit_z_n2741);
    setup_bump_unit_z_n2743_term <= resize(setup_bump_unit_x_n2216_s15, 26) xor (25 downto 0 => setup_bump_unit_z_n2739(0));
    setup_bump_unit_z_n2743 <= resize(setup_bump_unit_z_n2742, 26) + signed(setup_bump_unit_z_n2743_term) + setup_bump_unit_z_n2739(0);
    setup_bump_unit_z_n2744 <= setup_bump_unit_z_n2743(23 downto 0);
    setup_bump_unit_z_n2745 <= unsigned(setup_bump_unit_z_n2744(23 downto 23));
    setup_bump_unit_z_n2746 <= setup_bump_unit_z_n2745 xor setup_light_length_n42;
    setup_bump_unit_z_n2747 <= unsigned(setup_bump_unit_z_n2744);
    setup_bump_unit_z_n2748 <= setup_bump_unit_z_n2747 & setup_light_length_n43;
    setup_bump_unit_z_n2749 <= signed(setup_bump_unit_z_n2748);
    setup_bump_unit_z_n2815 <= setup_bump_unit_z_n2814_s15 & setup_bump_unit_z_n2739;
    setup_bump_unit_z_n2816 <= setup_bump_unit_z_n2815 & setup_bump_unit_z_n2746;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_unit_x_n344_s16 <= setup_light_unit_x_n344;
                setup_light_unit_x_n400_s16 <= setup_light_unit_x_n400;
                setup_light_unit_x_n404_s16 <= setup_light_unit_x_n404;
                setup_light_unit_x_n553_s16 <= setup_light_unit_x_n553;
                setup_light_unit_x_n555_s16 <= setup_light_unit_x_n555_s15;
                setup_light_unit_x_n557_s16 <= setup_light_unit_x_n557_s15;
                setup_light_unit_y_n615_s16 <= setup_light_unit_y_n615;
                setup_light_unit_y_n619_s16 <= setup_light_unit_y_n619;
                setup_light_unit_y_n767_s16 <= setup_light_unit_y_n767;
                setup_light_unit_y_n769_s16 <= setup_light_unit_y_n769_s15;
                setup_light_unit_y_n771_s16 <= setup_light_unit_y_n771_s15;
                setup_light_unit_z_n829_s16 <= setup_light_unit_z_n829;
                setup_light_unit_z_n833_s16 <= setup_light_unit_z_n833;
                setup_light_unit_z_n981_s16 <= setup_light_unit_z_n981;
                setup_light_unit_z_n983_s16 <= setup_light_unit_z_n983_s15;
                setup_light_unit_z_n985_s16 <= setup_light_unit_z_n985_s15;
                setup_half_unit_x_n1311_s16 <= setup_half_unit_x_n1311;
                setup_half_unit_x_n1365_s16 <= setup_half_unit_x_n1365;
                setup_half_unit_x_n1369_s16 <= setup_half_unit_x_n1369;
                setup_half_unit_x_n1518_s16 <= setup_half_unit_x_n1518;
                setup_half_unit_x_n1520_s16 <= setup_half_unit_x_n1520_s15;
                setup_half_unit_x_n1522_s16 <= setup_half_unit_x_n1522_s15;
                setup_half_unit_y_n1580_s16 <= setup_half_unit_y_n1580;
                setup_half_unit_y_n1584_s16 <= setup_half_unit_y_n1584;
                setup_half_unit_y_n1732_s16 <= setup_half_unit_y_n1732;
                setup_half_unit_y_n1734_s16 <= setup_half_unit_y_n1734_s15;
                setup_half_unit_y_n1736_s16 <= setup_half_unit_y_n1736_s15;
                setup_half_unit_z_n1794_s16 <= setup_half_unit_z_n1794;
                setup_half_unit_z_n1798_s16 <= setup_half_unit_z_n1798;
                setup_half_unit_z_n1946_s16 <= setup_half_unit_z_n1946;
                setup_half_unit_z_n1948_s16 <= setup_half_unit_z_n1948_s15;
                setup_half_unit_z_n1950_s16 <= setup_half_unit_z_n1950_s15;
                setup_bump_unit_x_n2216_s16 <= setup_bump_unit_x_n2216_s15;
                setup_bump_unit_x_n2333_s16 <= setup_bump_unit_x_n2333;
                setup_bump_unit_x_n2336_s16 <= setup_bump_unit_x_n2336;
                setup_bump_unit_x_n2403_s16 <= setup_bump_unit_x_n2403;
                setup_bump_unit_x_n2415_s16 <= setup_bump_unit_x_n2415_s15;
                setup_bump_unit_x_n2417_s16 <= setup_bump_unit_x_n2417_s15;
                setup_bump_unit_x_n2419_s16 <= setup_bump_unit_x_n2419_s15;
                setup_bump_unit_y_n2540_s16 <= setup_bump_unit_y_n2540;
                setup_bump_unit_y_n2543_s16 <= setup_bump_unit_y_n2543;
                setup_bump_unit_y_n2610_s16 <= setup_bump_unit_y_n2610;
                setup_bump_unit_y_n2621_s16 <= setup_bump_unit_y_n2621_s15;
                setup_bump_unit_y_n2623_s16 <= setup_bump_unit_y_n2623_s15;
                setup_bump_unit_y_n2625_s16 <= setup_bump_unit_y_n2625_s15;
                setup_bump_unit_z_n2746_s16 <= setup_bump_unit_z_n2746;
                setup_bump_unit_z_n2749_s16 <= setup_bump_unit_z_n2749;
                setup_bump_unit_z_n2816_s16 <= setup_bump_unit_z_n2816;
                setup_bump_unit_z_n2827_s16 <= setup_bump_unit_z_n2827_s15;
                setup_bump_unit_z_n2829_s16 <= setup_bump_unit_z_n2829_s15;
                setup_bump_unit_z_n2831_s16 <= setup_bump_unit_z_n2831_s15;
            end if;
            if rst = '1' then
                valid_s16 <= '0';
            elsif ce = '1' then
                valid_s16 <= valid_s15;
            end if;
        end if;
    end process;

    -- ---- stage 16 ----
    -- setup.light.unit_x
    setup_light_unit_x_n405_term <= resize(setup_light_unit_x_n344_s16, 26) xor (25 downto 0 => setup_light_unit_x_n400_s16(0));
    setup_light_unit_x_n405 <= resize(setup_light_unit_x_n404_s16, 26) + signed(setup_light_unit_x_n405_term) + setup_light_unit_x_n400_s16(0);
    setup_light_unit_x_n406 <= setup_light_unit_x_n405(23 downto 0);
    setup_light_unit_x_n407 <= unsigned(setup_light_unit_x_n406(23 downto 23));
    setup_light_unit_x_n408 <= setup_light_unit_x_n407 xor setup_light_length_n42;
    setup_light_unit_x_n409 <= unsigned(setup_light_unit_x_n406);
    setup_light_unit_x_n410 <= setup_light_unit_x_n409 & setup_light_length_n43;
    setup_light_unit_x_n411 <= signed(setup_light_unit_x_n410);
    setup_light_unit_x_n412_term <= resize(setup_light_unit_x_n344_s16, 26) xor (25 downto 0 => setup_light_unit_x_n408(0));
    setup_light_unit_x_n412 <= resize(setup_light_unit_x_n411, 26) + signed(setup_light_unit_x_n412_term) + setup_light_unit_x_n408(0);
    setup_light_unit_x_n413 <= setup_light_unit_x_n412(23 downto 0);
    setup_light_unit_x_n414 <= unsigned(setup_light_unit_x_n413(23 downto 23));
    setup_light_unit_x_n415 <= setup_light_unit_x_n414 xor setup_light_length_n42;
    setup_light_unit_x_n416 <= unsigned(setup_light_unit_x_n413);
    setup_light_unit_x_n417 <= setup_light_unit_x_n416 & setup_light_length_n43;
    setup_light_unit_x_n418 <= signed(setup_light_unit_x_n417);
    setup_light_unit_x_n532 <= setup_light_unit_x_n400_s16 & setup_light_unit_x_n408;
    setup_light_unit_x_n533 <= setup_light_unit_x_n532 & setup_light_unit_x_n415;
    -- setup.light.unit_y
    setup_light_unit_y_n620_term <= resize(setup_light_unit_x_n344_s16, 26) xor (25 downto 0 => setup_light_unit_y_n615_s16(0));
    setup_light_unit_y_n620 <= resize(setup_light_unit_y_n619_s16, 26) + signed(setup_light_unit_y_n620_term) + setup_light_unit_y_n615_s16(0);
    setup_light_unit_y_n621 <= setup_light_unit_y_n620(23 downto 0);
    setup_light_unit_y_n622 <= unsigned(setup_light_unit_y_n621(23 downto 23));
    setup_light_unit_y_n623 <= setup_light_unit_y_n622 xor setup_light_length_n42;
    setup_light_unit_y_n624 <= unsigned(setup_light_unit_y_n621);
    setup_light_unit_y_n625 <= setup_light_unit_y_n624 & setup_light_length_n43;
    setup_light_unit_y_n626 <= signed(setup_light_unit_y_n625);
    setup_light_unit_y_n627_term <= resize(setup_light_unit_x_n344_s16, 26) xor (25 downto 0 => setup_light_unit_y_n623(0));
    setup_light_unit_y_n627 <= resize(setup_light_unit_y_n626, 26) + signed(setup_light_unit_y_n627_term) + setup_light_unit_y_n623(0);
    setup_light_unit_y_n628 <= setup_light_unit_y_n627(23 downto 0);
    setup_light_unit_y_n629 <= unsigned(setup_light_unit_y_n628(23 downto 23));
    setup_light_unit_y_n630 <= setup_light_unit_y_n629 xor setup_light_length_n42;
    setup_light_unit_y_n631 <= unsigned(setup_light_unit_y_n628);
    setup_light_unit_y_n632 <= setup_light_unit_y_n631 & setup_light_length_n43;
    setup_light_unit_y_n633 <= signed(setup_light_unit_y_n632);
    setup_light_unit_y_n747 <= setup_light_unit_y_n615_s16 & setup_light_unit_y_n623;
    setup_light_unit_y_n748 <= setup_light_unit_y_n747 & setup_light_unit_y_n630;
    -- setup.light.unit_z
    setup_light_unit_z_n834_term <= resize(setup_light_unit_x_n344_s16, 26) xor (25 downto 0 => setup_light_unit_z_n829_s16(0));
    setup_light_unit_z_n834 <= resize(setup_light_unit_z_n833_s16, 26) + signed(setup_light_unit_z_n834_term) + setup_light_unit_z_n829_s16(0);
    setup_light_unit_z_n835 <= setup_light_unit_z_n834(23 downto 0);
    setup_light_unit_z_n836 <= unsigned(setup_light_unit_z_n835(23 downto 23));
    setup_light_unit_z_n837 <= setup_light_unit_z_n836 xor setup_light_length_n42;
    setup_light_unit_z_n838 <= unsigned(setup_light_unit_z_n835);
    setup_light_unit_z_n839 <= setup_light_unit_z_n838 & setup_light_length_n43;
    setup_light_unit_z_n840 <= signed(setup_light_unit_z_n839);
    setup_light_unit_z_n841_term <= resize(setup_light_unit_x_n344_s16, 26) xor (25 downto 0 => setup_light_unit_z_n837(0));
    setup_light_unit_z_n841 <= resize(setup_light_unit_z_n840, 26) + signed(setup_light_unit_z_n841_term) + setup_light_unit_z_n837(0);
    setup_light_unit_z_n842 <= setup_light_unit_z_n841(23 downto 0);
    setup_light_unit_z_n843 <= unsigned(setup_light_unit_z_n842(23 downto 23));
    setup_light_unit_z_n844 <= setup_light_unit_z_n843 xor setup_light_length_n42;
    setup_light_unit_z_n845 <= unsigned(setup_light_unit_z_n842);
    setup_light_unit_z_n846 <= setup_light_unit_z_n845 & setup_light_length_n43;
    setup_light_unit_z_n847 <= signed(setup_light_unit_z_n846);
    setup_light_unit_z_n961 <= setup_light_unit_z_n829_s16 & setup_light_unit_z_n837;
    setup_light_unit_z_n962 <= setup_light_unit_z_n961 & setup_light_unit_z_n844;
    -- setup.half.unit_x
    setup_half_unit_x_n1370_term <= resize(setup_half_unit_x_n1311_s16, 26) xor (25 downto 0 => setup_half_unit_x_n1365_s16(0));
    setup_half_unit_x_n1370 <= resize(setup_half_unit_x_n1369_s16, 26) + signed(setup_half_unit_x_n1370_term) + setup_half_unit_x_n1365_s16(0);
    setup_half_unit_x_n1371 <= setup_half_unit_x_n1370(23 downto 0);
    setup_half_unit_x_n1372 <= unsigned(setup_half_unit_x_n1371(23 downto 23));
    setup_half_unit_x_n1373 <= setup_half_unit_x_n1372 xor setup_light_length_n42;
    setup_half_unit_x_n1374 <= unsigned(setup_half_unit_x_n1371);
    setup_half_unit_x_n1375 <= setup_half_unit_x_n1374 & setup_light_length_n43;
    setup_half_unit_x_n1376 <= signed(setup_half_unit_x_n1375);
    setup_half_unit_x_n1377_term <= resize(setup_half_unit_x_n1311_s16, 26) xor (25 downto 0 => setup_half_unit_x_n1373(0));
    setup_half_unit_x_n1377 <= resize(setup_half_unit_x_n1376, 26) + signed(setup_half_unit_x_n1377_term) + setup_half_unit_x_n1373(0);
    setup_half_unit_x_n1378 <= setup_half_unit_x_n1377(23 downto 0);
    setup_half_unit_x_n1379 <= unsigned(setup_half_unit_x_n1378(23 downto 23));
    setup_half_unit_x_n1380 <= setup_half_unit_x_n1379 xor setup_light_length_n42;
    setup_half_unit_x_n1381 <= unsigned(setup_half_unit_x_n1378);
    setup_half_unit_x_n1382 <= setup_half_unit_x_n1381 & setup_light_length_n43;
    setup_half_unit_x_n1383 <= signed(setup_half_unit_x_n1382);
    setup_half_unit_x_n1497 <= setup_half_unit_x_n1365_s16 & setup_half_unit_x_n1373;
    setup_half_unit_x_n1498 <= setup_half_unit_x_n1497 & setup_half_unit_x_n1380;
    -- setup.half.unit_y
    setup_half_unit_y_n1585_term <= resize(setup_half_unit_x_n1311_s16, 26) xor (25 downto 0 => setup_half_unit_y_n1580_s16(0));
    setup_half_unit_y_n1585 <= resize(setup_half_unit_y_n1584_s16, 26) + signed(setup_half_unit_y_n1585_term) + setup_half_unit_y_n1580_s16(0);
    setup_half_unit_y_n1586 <= setup_half_unit_y_n1585(23 downto 0);
    setup_half_unit_y_n1587 <= unsigned(setup_half_unit_y_n1586(23 downto 23));
    setup_half_unit_y_n1588 <= setup_half_unit_y_n1587 xor setup_light_length_n42;
    setup_half_unit_y_n1589 <= unsigned(setup_half_unit_y_n1586);
    setup_half_unit_y_n1590 <= setup_half_unit_y_n1589 & setup_light_length_n43;
    setup_half_unit_y_n1591 <= signed(setup_half_unit_y_n1590);
    setup_half_unit_y_n1592_term <= resize(setup_half_unit_x_n1311_s16, 26) xor (25 downto 0 => setup_half_unit_y_n1588(0));
    setup_half_unit_y_n1592 <= resize(setup_half_unit_y_n1591, 26) + signed(setup_half_unit_y_n1592_term) + setup_half_unit_y_n1588(0);
    setup_half_unit_y_n1593 <= setup_half_unit_y_n1592(23 downto 0);
    setup_half_unit_y_n1594 <= unsigned(setup_half_unit_y_n1593(23 downto 23));
    setup_half_unit_y_n1595 <= setup_half_unit_y_n1594 xor setup_light_length_n42;
    setup_half_unit_y_n1596 <= unsigned(setup_half_unit_y_n1593);
    setup_half_unit_y_n1597 <= setup_half_unit_y_n1596 & setup_light_length_n43;
    setup_half_unit_y_n1598 <= signed(setup_half_unit_y_n1597);
    setup_half_unit_y_n1712 <= setup_half_unit_y_n1580_s16 & setup_half_unit_y_n1588;
    setup_half_unit_y_n1713 <= setup_half_unit_y_n1712 & setup_half_unit_y_n1595;
    -- setup.half.unit_z
    setup_half_unit_z_n1799_term <= resize(setup_half_unit_x_n1311_s16, 26) xor (25 downto 0 => setup_half_unit_z_n1794_s16(0));
    setup_half_unit_z_n1799 <= resize(setup_half_unit_z_n1798_s16, 26) + signed(setup_half_unit_z_n1799_term) + setup_half_unit_z_n1794_s16(0);
    setup_half_unit_z_n1800 <= setup_half_unit_z_n1799(23 downto 0);
    setup_half_unit_z_n1801 <= unsigned(setup_half_unit_z_n1800(23 downto 23));
    setup_half_unit_z_n1802 <= setup_half_unit_z_n1801 xor setup_light_length_n42;
    setup_half_unit_z_n1803 <= unsigned(setup_half_unit_z_n1800);
    setup_half_unit_z_n1804 <= setup_half_unit_z_n1803 & setup_light_length_n43;
    setup_half_unit_z_n1805 <= signed(setup_half_unit_z_n1804);
    setup_half_unit_z_n1806_term <= resize(setup_half_unit_x_n1311_s16, 26) xor (25 downto 0 => setup_half_unit_z_n1802(0));
    setup_half_unit_z_n1806 <= resize(setup_half_unit_z_n1805, 26) + signed(setup_half_unit_z_n1806_term) + setup_half_unit_z_n1802(0);
    setup_half_unit_z_n1807 <= setup_half_unit_z_n1806(23 downto 0);
    setup_half_unit_z_n1808 <= unsigned(setup_half_unit_z_n1807(23 downto 23));
    setup_half_unit_z_n1809 <= setup_half_unit_z_n1808 xor setup_light_length_n42;
    setup_half_unit_z_n1810 <= unsigned(setup_half_unit_z_n1807);
    setup_half_unit_z_n1811 <= setup_half_unit_z_n1810 & setup_light_length_n43;
    setup_half_unit_z_n1812 <= signed(setup_half_unit_z_n1811);
    setup_half_unit_z_n1926 <= setup_half_unit_z_n1794_s16 & setup_half_unit_z_n1802;
    setup_half_unit_z_n1927 <= setup_half_unit_z_n1926 & setup_half_unit_z_n1809;
    -- setup.bump.unit_x
    setup_bump_unit_x_n2337_term <= resize(setup_bump_unit_x_n2216_s16, 26) xor (25 downto 0 => setup_bump_unit_x_n2333_s16(0));
    setup_bump_unit_x_n2337 <= resize(setup_bump_unit_x_n2336_s16, 26) + signed(setup_bump_unit_x_n2337_term) + setup_bump_unit_x_n2333_s16(0);
    setup_bump_unit_x_n2338 <= setup_bump_unit_x_n2337(23 downto 0);
    setup_bump_unit_x_n2339 <= unsigned(setup_bump_unit_x_n2338(23 downto 23));
    setup_bump_unit_x_n2340 <= setup_bump_unit_x_n2339 xor setup_light_length_n42;
    setup_bump_unit_x_n2341 <= unsigned(setup_bump_unit_x_n2338);
    setup_bump_unit_x_n2342 <= setup_bump_unit_x_n2341 & setup_light_length_n43;
    setup_bump_unit_x_n2343 <= signed(setup_bump_unit_x_n2342);
    setup_bump_unit_x_n2344_term <= resize(setup_bump_unit_x_n2216_s16, 26) xor (25 downto 0 => setup_bump_unit_x_n2340(0));
    setup_bump_unit_x_n2344 <= resize(setup_bump_unit_x_n2343, 26) + signed(setup_bump_unit_x_n2344_term) + setup_bump_unit_x_n2340(0);
    setup_bump_unit_x_n2345 <= setup_bump_unit_x_n2344(23 downto 0);
    setup_bump_unit_x_n2346 <= unsigned(setup_bump_unit_x_n2345(23 downto 23));
    setup_bump_unit_x_n2347 <= setup_bump_unit_x_n2346 xor setup_light_length_n42;
    setup_bump_unit_x_n2348 <= unsigned(setup_bump_unit_x_n2345);
    setup_bump_unit_x_n2349 <= setup_bump_unit_x_n2348 & setup_light_length_n43;
    setup_bump_unit_x_n2350 <= signed(setup_bump_unit_x_n2349);
    setup_bump_unit_x_n2404 <= setup_bump_unit_x_n2403_s16 & setup_bump_unit_x_n2340;
    setup_bump_unit_x_n2405 <= setup_bump_unit_x_n2404 & setup_bump_unit_x_n2347;
    -- setup.bump.unit_y
    setup_bump_unit_y_n2544_term <= resize(setup_bump_unit_x_n2216_s16, 26) xor (25 downto 0 => setup_bump_unit_y_n2540_s16(0));
    setup_bump_unit_y_n2544 <= resize(setup_bump_unit_y_n2543_s16, 26) + signed(setup_bump_unit_y_n2544_term) + setup_bump_unit_y_n2540_s16(0);
    setup_bump_unit_y_n2545 <= setup_bump_unit_y_n2544(23 downto 0);
    setup_bump_unit_y_n2546 <= unsigned(setup_bump_unit_y_n2545(23 downto 23));
    setup_bump_unit_y_n2547 <= setup_bump_unit_y_n2546 xor setup_light_length_n42;
    setup_bump_unit_y_n2548 <= unsigned(setup_bump_unit_y_n2545);
    setup_bump_unit_y_n2549 <= setup_bump_unit_y_n2548 & setup_light_length_n43;
    setup_bump_unit_y_n2550 <= signed(setup_bump_unit_y_n2549);
    setup_bump_unit_y_n2551_term <= resize(setup_bump_unit_x_n2216_s16, 26) xor (25 downto 0 => setup_bump_unit_y_n2547(0));
    setup_bump_unit_y_n2551 <= resize(setup_bump_unit_y_n2550, 26) + signed(setup_bump_unit_y_n2551_term) + setup_bump_unit_y_n2547(0);
    setup_bump_unit_y_n2552 <= setup_bump_unit_y_n2551(23 downto 0);
    setup_bump_unit_y_n2553 <= unsigned(setup_bump_unit_y_n2552(23 downto 23));
    setup_bump_unit_y_n2554 <= setup_bump_unit_y_n2553 xor setup_light_length_n42;
    setup_bump_unit_y_n2555 <= unsigned(setup_bump_unit_y_n2552);
    setup_bump_unit_y_n2556 <= setup_bump_unit_y_n2555 & setup_light_length_n43;
    setup_bump_unit_y_n2557 <= signed(setup_bump_unit_y_n2556);
    setup_bump_unit_y_n2611 <= setup_bump_unit_y_n2610_s16 & setup_bump_unit_y_n2547;
    setup_bump_unit_y_n2612 <= setup_bump_unit_y_n2611 & setup_bump_unit_y_n2554;
    -- setup.bump.unit_z
    setup_bump_unit_z_n2750_term <= resize(setup_bump_unit_x_n2216_s16, 26) xor (25 downto 0 => setup_bump_unit_z_n2746_s16(0));
    setup_bump_unit_z_n2750 <= resize(setup_bump_unit_z_n2749_s16, 26) + signed(setup_bump_unit_z_n2750_term) + setup_bump_unit_z_n2746_s16(0);
    setup_bump_unit_z_n2751 <= setup_bump_unit_z_n2750(23 downto 0);
    setup_bump_unit_z_n2752 <= unsigned(setup_bump_unit_z_n2751(23 downto 23));
    setup_bump_unit_z_n2753 <= setup_bump_unit_z_n2752 xor setup_light_length_n42;
    setup_bump_unit_z_n2754 <= unsigned(setup_bump_unit_z_n2751);
    setup_bump_unit_z_n2755 <= setup_bump_unit_z_n2754 & setup_light_length_n43;
    setup_bump_unit_z_n2756 <= signed(setup_bump_unit_z_n2755);
    setup_bump_unit_z_n2757_term <= resize(setup_bump_unit_x_n2216_s16, 26) xor (25 downto 0 => setup_bump_unit_z_n2753(0));
    setup_bump_unit_z_n2757 <= resize(setup_bump_unit_z_n2756, 26) + signed(setup_bump_unit_z_n2757_term) + setup_bump_unit_z_n2753(0);
    setup_bump_unit_z_n2758 <= setup_bump_unit_z_n2757(23 downto 0);
    setup_bump_unit_z_n2759 <= unsigned(setup_bump_unit_z_n2758(23 downto 23));
    setup_bump_unit_z_n2760 <= setup_bump_unit_z_n2759 xor setup_light_length_n42;
    setup_bump_unit_z_n2761 <= unsigned(setup_bump_unit_z_n2758);
    setup_bump_unit_z_n2762 <= setup_bump_unit_z_n2761 & setup_light_length_n43;
    setup_bump_unit_z_n2763 <= signed(setup_bump_unit_z_n2762);
    setup_bump_unit_z_n2817 <= setup_bump_unit_z_n2816_s16 & setup_bump_unit_z_n2753;
    setup_bump_unit_z_n2818 <= setup_bump_unit_z_n2817 & setup_bump_unit_z_n2760;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_unit_x_n344_s17 <= setup_light_unit_x_n344_s16;
                setup_light_unit_x_n415_s17 <= setup_light_unit_x_n415;
                setup_light_unit_x_n418_s17 <= setup_light_unit_x_n418;
                setup_light_unit_x_n533_s17 <= setup_light_unit_x_n533;
                setup_light_unit_x_n553_s17 <= setup_light_unit_x_n553_s16;
                setup_light_unit_x_n555_s17 <= setup_light_unit_x_n555_s16;
                setup_light_unit_x_n557_s17 <= setup_light_unit_x_n557_s16;
                setup_light_unit_y_n630_s17 <= setup_light_unit_y_n630;
                setup_light_unit_y_n633_s17 <= setup_light_unit_y_n633;
                setup_light_unit_y_n748_s17 <= setup_light_unit_y_n748;
                setup_light_unit_y_n767_s17 <= setup_light_unit_y_n767_s16;
                setup_light_unit_y_n769_s17 <= setup_light_unit_y_n769_s16;
                setup_light_unit_y_n771_s17 <= setup_light_unit_y_n771_s16;
                setup_light_unit_z_n844_s17 <= setup_light_unit_z_n844;
                setup_light_unit_z_n847_s17 <= setup_light_unit_z_n847;
                setup_light_unit_z_n962_s17 <= setup_light_unit_z_n962;
                setup_light_unit_z_n981_s17 <= setup_light_unit_z_n981_s16;
                setup_light_unit_z_n983_s17 <= setup_light_unit_z_n983_s16;
                setup_light_unit_z_n985_s17 <= setup_light_unit_z_n985_s16;
                setup_half_unit_x_n1311_s17 <= setup_half_unit_x_n1311_s16;
                setup_half_unit_x_n1380_s17 <= setup_half_unit_x_n1380;
                setup_half_unit_x_n1383_s17 <= setup_half_unit_x_n1383;
                setup_half_unit_x_n1498_s17 <= setup_half_unit_x_n1498;
                setup_half_unit_x_n1518_s17 <= setup_half_unit_x_n1518_s16;
                setup_half_unit_x_n1520_s17 <= setup_half_unit_x_n1520_s16;
                setup_half_unit_x_n1522_s17 <= setup_half_unit_x_n1522_s16;
                setup_half_unit_y_n1595_s17 <= setup_half_unit_y_n1595;
                setup_half_unit_y_n1598_s17 <= setup_half_unit_y_n1598;
                setup_half_unit_y_n1713_s17 <= setup_half_unit_y_n1713;
                setup_half_unit_y_n1732_s17 <= setup_half_unit_y_n1732_s16;
                setup_half_unit_y_n1734_s17 <= setup_half_unit_y_n1734_s16;
                setup_half_unit_y_n1736_s17 <= setup_half_unit_y_n1736_s16;
                setup_half_unit_z_n1809_s17 <= setup_half_unit_z_n1809;
                setup_half_unit_z_n1812_s17 <= setup_half_unit_z_n1812;
                setup_half_unit_z_n1927_s17 <= setup_half_unit_z_n1927;
                setup_half_unit_z_n1946_s17 <= setup_half_unit_z_n1946_s16;
                setup_half_unit_z_n1948_s17 <= setup_half_unit_z_n1948_s16;
                setup_half_unit_z_n1950_s17 <= setup_half_unit_z_n1950_s16;
                setup_bump_unit_x_n2216_s17 <= setup_bump_unit_x_n2216_s16;
                setup_bump_unit_x_n2347_s17 <= setup_bump_unit_x_n2347;
                setup_bump_unit_x_n2350_s17 <= setup_bump_unit_x_n2350;
                setup_bump_unit_x_n2405_s17 <= setup_bump_unit_x_n2405;
                setup_bump_unit_x_n2415_s17 <= setup_bump_unit_x_n2415_s16;
                setup_bump_unit_x_n2417_s17 <= setup_bump_unit_x_n2417_s16;
                setup_bump_unit_x_n2419_s17 <= setup_bump_unit_x_n2419_s16;
                setup_bump_unit_y_n2554_s17 <= setup_bump_unit_y_n2554;
                setup_bump_unit_y_n2557_s17 <= setup_bump_unit_y_n2557;
                setup_bump_unit_y_n2612_s17 <= setup_bump_unit_y_n2612;
                setup_bump_unit_y_n2621_s17 <= setup_bump_unit_y_n2621_s16;
                setup_bump_unit_y_n2623_s17 <= setup_bump_unit_y_n2623_s16;
                setup_bump_unit_y_n2625_s17 <= setup_bump_unit_y_n2625_s16;
                setup_bump_unit_z_n2760_s17 <= setup_bump_unit_z_n2760;
                setup_bump_unit_z_n2763_s17 <= setup_bump_unit_z_n2763;
                setup_bump_unit_z_n2818_s17 <= setup_bump_unit_z_n2818;
                setup_bump_unit_z_n2827_s17 <= setup_bump_unit_z_n2827_s16;
                setup_bump_unit_z_n2829_s17 <= setup_bump_unit_z_n2829_s16;
                setup_bump_unit_z_n2831_s17 <= setup_bump_unit_z_n2831_s16;
            end if;
            if rst = '1' then
                valid_s17 <= '0';
            elsif ce = '1' then
                valid_s17 <= valid_s16;
            end if;
        end if;
    end process;

    -- ---- stage 17 ----
    -- setup.light.unit_x
    setup_light_unit_x_n419_term <= resize(setup_light_unit_x_n344_s17, 26) xor (25 downto 0 => setup_light_unit_x_n415_s17(0));
    setup_light_unit_x_n419 <= resize(setup_light_unit_x_n418_s17, 26) + signed(setup_light_unit_x_n419_term) + setup_light_unit_x_n415_s17(0);
    setup_light_unit_x_n420 <= setup_light_unit_x_n419(23 downto 0);
    setup_light_unit_x_n421 <= unsigned(setup_light_unit_x_n420(23 downto 23));
    setup_light_unit_x_n422 <= setup_light_unit_x_n421 xor setup_light_length_n42;
    setup_light_unit_x_n423 <= unsigned(setup_light_unit_x_n420);
    setup_light_unit_x_n424 <= setup_light_unit_x_n423 & setup_light_length_n43;
    setup_light_unit_x_n425 <= signed(setup_light_unit_x_n424);
    setup_light_unit_x_n426_term <= resize(setup_light_unit_x_n344_s17, 26) xor (25 downto 0 => setup_light_unit_x_n422(0));
    setup_light_unit_x_n426 <= resize(setup_light_unit_x_n425, 26) + signed(setup_light_unit_x_n426_term) + setup_light_unit_x_n422(0);
    setup_light_unit_x_n427 <= setup_light_unit_x_n426(23 downto 0);
    setup_light_unit_x_n428 <= unsigned(setup_light_unit_x_n427(23 downto 23));
    setup_light_unit_x_n429 <= setup_light_unit_x_n428 xor setup_light_length_n42;
    setup_light_unit_x_n430 <= unsigned(setup_light_unit_x_n427);
    setup_light_unit_x_n431 <= setup_light_unit_x_n430 & setup_light_length_n43;
    setup_light_unit_x_n432 <= signed(setup_light_unit_x_n431);
    setup_light_unit_x_n534 <= setup_light_unit_x_n533_s17 & setup_light_unit_x_n422;
    setup_light_unit_x_n535 <= setup_light_unit_x_n534 & setup_light_unit_x_n429;
    -- setup.light.unit_y
    setup_light_unit_y_n634_term <= resize(setup_light_unit_x_n344_s17, 26) xor (25 downto 0 => setup_light_unit_y_n630_s17(0));
    setup_light_unit_y_n634 <= resize(setup_light_unit_y_n633_s17, 26) + signed(setup_light_unit_y_n634_term) + setup_light_unit_y_n630_s17(0);
    setup_light_unit_y_n635 <= setup_light_unit_y_n634(23 downto 0);
    setup_light_unit_y_n636 <= unsigned(setup_light_unit_y_n635(23 downto 23));
    setup_light_unit_y_n637 <= setup_light_unit_y_n636 xor setup_light_length_n42;
    setup_light_unit_y_n638 <= unsigned(setup_light_unit_y_n635);
    setup_light_unit_y_n639 <= setup_light_unit_y_n638 & setup_light_length_n43;
    setup_light_unit_y_n640 <= signed(setup_light_unit_y_n639);
    setup_light_unit_y_n641_term <= resize(setup_light_unit_x_n344_s17, 26) xor (25 downto 0 => setup_light_unit_y_n637(0));
    setup_light_unit_y_n641 <= resize(setup_light_unit_y_n640, 26) + signed(setup_light_unit_y_n641_term) + setup_light_unit_y_n637(0);
    setup_light_unit_y_n642 <= setup_light_unit_y_n641(23 downto 0);
    setup_light_unit_y_n643 <= unsigned(setup_light_unit_y_n642(23 downto 23));
    setup_light_unit_y_n644 <= setup_light_unit_y_n643 xor setup_light_length_n42;
    setup_light_unit_y_n645 <= unsigned(setup_light_unit_y_n642);
    setup_light_unit_y_n646 <= setup_light_unit_y_n645 & setup_light_length_n43;
    setup_light_unit_y_n647 <= signed(setup_light_unit_y_n646);
    setup_light_unit_y_n749 <= setup_light_unit_y_n748_s17 & setup_light_unit_y_n637;
    setup_light_unit_y_n750 <= setup_light_unit_y_n749 & setup_light_unit_y_n644;
    -- setup.light.unit_z
    setup_light_unit_z_n848_term <= resize(setup_light_unit_x_n344_s17, 26) xor (25 downto 0 => setup_light_unit_z_n844_s17(0));
    setup_light_unit_z_n848 <= resize(setup_light_unit_z_n847_s17, 26) + signed(setup_light_unit_z_n848_term) + setup_light_unit_z_n844_s17(0);
    setup_light_unit_z_n849 <= setup_light_unit_z_n848(23 downto 0);
    setup_light_unit_z_n850 <= unsigned(setup_light_unit_z_n849(23 downto 23));
    setup_light_unit_z_n851 <= setup_light_unit_z_n850 xor setup_light_length_n42;
    setup_light_unit_z_n852 <= unsigned(setup_light_unit_z_n849);
    setup_light_unit_z_n853 <= setup_light_unit_z_n852 & setup_light_length_n43;
    setup_light_unit_z_n854 <= signed(setup_light_unit_z_n853);
    setup_light_unit_z_n855_term <= resize(setup_light_unit_x_n344_s17, 26) xor (25 downto 0 => setup_light_unit_z_n851(0));
    setup_light_unit_z_n855 <= resize(setup_light_unit_z_n854, 26) + signed(setup_light_unit_z_n855_term) + setup_light_unit_z_n851(0);
    setup_light_unit_z_n856 <= setup_light_unit_z_n855(23 downto 0);
    setup_light_unit_z_n857 <= unsigned(setup_light_unit_z_n856(23 downto 23));
    setup_light_unit_z_n858 <= setup_light_unit_z_n857 xor setup_light_length_n42;
    setup_light_unit_z_n859 <= unsigned(setup_light_unit_z_n856);
    setup_light_unit_z_n860 <= setup_light_unit_z_n859 & setup_light_length_n43;
    setup_light_unit_z_n861 <= signed(setup_light_unit_z_n860);
    setup_light_unit_z_n963 <= setup_light_unit_z_n962_s17 & setup_light_unit_z_n851;
    setup_light_unit_z_n964 <= setup_light_unit_z_n963 & setup_light_unit_z_n858;
    -- setup.half.unit_x
    setup_half_unit_x_n1384_term <= resize(setup_half_unit_x_n1311_s17, 26) xor (25 downto 0 => setup_half_unit_x_n1380_s17(0));
    setup_half_unit_x_n1384 <= resize(setup_half_unit_x_n1383_s17, 26) + signed(setup_half_unit_x_n1384_term) + setup_half_unit_x_n1380_s17(0);
    setup_half_unit_x_n1385 <= setup_half_unit_x_n1384(23 downto 0);
    setup_half_unit_x_n1386 <= unsigned(setup_half_unit_x_n1385(23 downto 23));
    setup_half_unit_x_n1387 <= setup_half_unit_x_n1386 xor setup_light_length_n42;
    setup_half_unit_x_n1388 <= unsigned(setup_half_unit_x_n1385);
    setup_half_unit_x_n1389 <= setup_half_unit_x_n1388 & setup_light_length_n43;
    setup_half_unit_x_n1390 <= signed(setup_half_unit_x_n1389);
    setup_half_unit_x_n1391_term <= resize(setup_half_unit_x_n1311_s17, 26) xor (25 downto 0 => setup_half_unit_x_n1387(0));
    setup_half_unit_x_n1391 <= resize(setup_half_unit_x_n1390, 26) + signed(setup_half_unit_x_n1391_term) + setup_half_unit_x_n1387(0);
    setup_half_unit_x_n1392 <= setup_half_unit_x_n1391(23 downto 0);
    setup_half_unit_x_n1393 <= unsigned(setup_half_unit_x_n1392(23 downto 23));
    setup_half_unit_x_n1394 <= setup_half_unit_x_n1393 xor setup_light_length_n42;
    setup_half_unit_x_n1395 <= unsigned(setup_half_unit_x_n1392);
    setup_half_unit_x_n1396 <= setup_half_unit_x_n1395 & setup_light_length_n43;
    setup_half_unit_x_n1397 <= signed(setup_half_unit_x_n1396);
    setup_half_unit_x_n1499 <= setup_half_unit_x_n1498_s17 & setup_half_unit_x_n1387;
    setup_half_unit_x_n1500 <= setup_half_unit_x_n1499 & setup_half_unit_x_n1394;
    -- setup.half.unit_y
    setup_half_unit_y_n1599_term <= resize(setup_half_unit_x_n1311_s17, 26) xor (25 downto 0 => setup_half_unit_y_n1595_s17(0));
    setup_half_unit_y_n1599 <= resize(setup_half_unit_y_n1598_s17, 26) + signed(setup_half_unit_y_n1599_term) + setup_half_unit_y_n1595_s17(0);
    setup_half_unit_y_n1600 <= setup_half_unit_y_n1599(23 downto 0);
    setup_half_unit_y_n1601 <= unsigned(setup_half_unit_y_n1600(23 downto 23));
    setup_half_unit_y_n1602 <= setup_half_unit_y_n1601 xor setup_light_length_n42;
    setup_half_unit_y_n1603 <= unsigned(setup_half_unit_y_n1600);
    setup_half_unit_y_n1604 <= setup_half_unit_y_n1603 & setup_light_length_n43;
    setup_half_unit_y_n1605 <= signed(setup_half_unit_y_n1604);
    setup_half_unit_y_n1606_term <= resize(setup_half_unit_x_n1311_s17, 26) xor (25 downto 0 => setup_half_unit_y_n1602(0));
    setup_half_unit_y_n1606 <= resize(setup_half_unit_y_n1605, 26) + signed(setup_half_unit_y_n1606_term) + setup_half_unit_y_n1602(0);
    setup_half_unit_y_n1607 <= setup_half_unit_y_n1606(23 downto 0);
    setup_half_unit_y_n1608 <= unsigned(setup_half_unit_y_n1607(23 downto 23));
    setup_half_unit_y_n1609 <= setup_half_unit_y_n1608 xor setup_light_length_n42;
    setup_half_unit_y_n1610 <= unsigned(setup_half_unit_y_n1607);
    setup_half_unit_y_n1611 <= setup_half_unit_y_n1610 & setup_light_length_n43;
    setup_half_unit_y_n1612 <= signed(setup_half_unit_y_n1611);
    setup_half_unit_y_n1714 <= setup_half_unit_y_n1713_s17 & setup_half_unit_y_n1602;
    setup_half_unit_y_n1715 <= setup_half_unit_y_n1714 & setup_half_unit_y_n1609;
    -- setup.half.unit_z
    setup_half_unit_z_n1813_term <= resize(setup_half_unit_x_n1311_s17, 26) xor (25 downto 0 => setup_half_unit_z_n1809_s17(0));
    setup_half_unit_z_n1813 <= resize(setup_half_unit_z_n1812_s17, 26) + signed(setup_half_unit_z_n1813_term) + setup_half_unit_z_n1809_s17(0);
    setup_half_unit_z_n1814 <= setup_half_unit_z_n1813(23 downto 0);
    setup_half_unit_z_n1815 <= unsigned(setup_half_unit_z_n1814(23 downto 23));
    setup_half_unit_z_n1816 <= setup_half_unit_z_n1815 xor setup_light_length_n42;
    setup_half_unit_z_n1817 <= unsigned(setup_half_unit_z_n1814);
    setup_half_unit_z_n1818 <= setup_half_unit_z_n1817 & setup_light_length_n43;
    setup_half_unit_z_n1819 <= signed(setup_half_unit_z_n1818);
    setup_half_unit_z_n1820_term <= resize(setup_half_unit_x_n1311_s17, 26) xor (25 downto 0 => setup_half_unit_z_n1816(0));
    setup_half_unit_z_n1820 <= resize(setup_half_unit_z_n1819, 26) + signed(setup_half_unit_z_n1820_term) + setup_half_unit_z_n1816(0);
    setup_half_unit_z_n1821 <= setup_half_unit_z_n1820(23 downto 0);
    setup_half_unit_z_n1822 <= unsigned(setup_half_unit_z_n1821(23 downto 23));
    setup_half_unit_z_n1823 <= setup_half_unit_z_n1822 xor setup_light_length_n42;
    setup_half_unit_z_n1824 <= unsigned(setup_half_unit_z_n1821);
    setup_half_unit_z_n1825 <= setup_half_unit_z_n1824 & setup_light_length_n43;
    setup_half_unit_z_n1826 <= signed(setup_half_unit_z_n1825);
    setup_half_unit_z_n1928 <= setup_half_unit_z_n1927_s17 & setup_half_unit_z_n1816;
    setup_half_unit_z_n1929 <= setup_half_unit_z_n1928 & setup_half_unit_z_n1823;
    -- setup.bump.unit_x
    setup_bump_unit_x_n2351_term <= resize(setup_bump_unit_x_n2216_s17, 26) xor (25 downto 0 => setup_bump_unit_x_n2347_s17(0));
    setup_bump_unit_x_n2351 <= resize(setup_bump_unit_x_n2350_s17, 26) + signed(setup_bump_unit_x_n2351_term) + setup_bump_unit_x_n2347_s17(0);
    setup_bump_unit_x_n2352 <= setup_bump_unit_x_n2351(23 downto 0);
    setup_bump_unit_x_n2353 <= unsigned(setup_bump_unit_x_n2352(23 downto 23));
    setup_bump_unit_x_n2354 <= setup_bump_unit_x_n2353 xor setup_light_length_n42;
    setup_bump_unit_x_n2355 <= unsigned(setup_bump_unit_x_n2352);
    setup_bump_unit_x_n2356 <= setup_bump_unit_x_n2355 & setup_light_length_n43;
    setup_bump_unit_x_n2357 <= signed(setup_bump_unit_x_n2356);
    setup_bump_unit_x_n2358_term <= resize(setup_bump_unit_x_n2216_s17, 26) xor (25 downto 0 => setup_bump_unit_x_n2354(0));
    setup_bump_unit_x_n2358 <= resize(setup_bump_unit_x_n2357, 26) + signed(setup_bump_unit_x_n2358_term) + setup_bump_unit_x_n2354(0);
    setup_bump_unit_x_n2359 <= setup_bump_unit_x_n2358(23 downto 0);
    setup_bump_unit_x_n2360 <= unsigned(setup_bump_unit_x_n2359(23 downto 23));
    setup_bump_unit_x_n2361 <= setup_bump_unit_x_n2360 xor setup_light_length_n42;
    setup_bump_unit_x_n2362 <= unsigned(setup_bump_unit_x_n2359);
    setup_bump_unit_x_n2363 <= setup_bump_unit_x_n2362 & setup_light_length_n43;
    setup_bump_unit_x_n2364 <= signed(setup_bump_unit_x_n2363);
    setup_bump_unit_x_n2406 <= setup_bump_unit_x_n2405_s17 & setup_bump_unit_x_n2354;
    setup_bump_unit_x_n2407 <= setup_bump_unit_x_n2406 & setup_bump_unit_x_n2361;
    -- setup.bump.unit_y
    setup_bump_unit_y_n2558_term <= resize(setup_bump_unit_x_n2216_s17, 26) xor (25 downto 0 => setup_bump_unit_y_n2554_s17(0));
    setup_bump_unit_y_n2558 <= resize(setup_bump_unit_y_n2557_s17, 26) + signed(setup_bump_unit_y_n2558_term) + setup_bump_unit_y_n2554_s17(0);
    setup_bump_unit_y_n2559 <= setup_bump_unit_y_n2558(23 downto 0);
    setup_bump_unit_y_n2560 <= unsigned(setup_bump_unit_y_n2559(23 downto 23));
    setup_bump_unit_y_n2561 <= setup_bump_unit_y_n2560 xor setup_light_length_n42;
    setup_bump_unit_y_n2562 <= unsigned(setup_bump_unit_y_n2559);
    setup_bump_unit_y_n2563 <= setup_bump_unit_y_n2562 & setup_light_length_n43;
    setup_bump_unit_y_n2564 <= signed(setup_bump_unit_y_n2563);
    setup_bump_unit_y_n2565_term <= resize(setup_bump_unit_x_n2216_s17, 26) xor (25 downto 0 => setup_bump_unit_y_n2561(0));
    setup_bump_unit_y_n2565 <= resize(setup_bump_unit_y_n2564, 26) + signed(setup_bump_unit_y_n2565_term) + setup_bump_unit_y_n2561(0);
    setup_bump_unit_y_n2566 <= setup_bump_unit_y_n2565(23 downto 0);
    setup_bump_unit_y_n2567 <= unsigned(setup_bump_unit_y_n2566(23 downto 23));
    setup_bump_unit_y_n2568 <= setup_bump_unit_y_n2567 xor setup_light_length_n42;
    setup_bump_unit_y_n2569 <= unsigned(setup_bump_unit_y_n2566);
    setup_bump_unit_y_n2570 <= setup_bump_unit_y_n2569 & setup_light_length_n43;
    setup_bump_unit_y_n2571 <= signed(setup_bump_unit_y_n2570);
    setup_bump_unit_y_n2613 <= setup_bump_unit_y_n2612_s17 & setup_bump_unit_y_n2561;
    setup_bump_unit_y_n2614 <= setup_bump_unit_y_n2613 & setup_bump_unit_y_n2568;
    -- setup.bump.unit_z
    setup_bump_unit_z_n2764_term <= resize(setup_bump_unit_x_n2216_s17, 26) xor (25 downto 0 => setup_bump_unit_z_n2760_s17(0));
    setup_bump_unit_z_n2764 <= resize(setup_bump_unit_z_n2763_s17, 26) + signed(setup_bump_unit_z_n2764_term) + setup_bump_unit_z_n2760_s17(0);
    setup_bump_unit_z_n2765 <= setup_bump_unit_z_n2764(23 downto 0);
    setup_bump_unit_z_n2766 <= unsigned(setup_bump_unit_z_n2765(23 downto 23));
    setup_bump_unit_z_n2767 <= setup_bump_unit_z_n2766 xor setup_light_length_n42;
    setup_bump_unit_z_n2768 <= unsigned(setup_bump_unit_z_n2765);
    setup_bump_unit_z_n2769 <= setup_bump_unit_z_n2768 & setup_light_length_n43;
    setup_bump_unit_z_n2770 <= signed(setup_bump_unit_z_n2769);
    setup_bump_unit_z_n2771_term <= resize(setup_bump_unit_x_n2216_s17, 26) xor (25 downto 0 => setup_bump_unit_z_n2767(0));
    setup_bump_unit_z_n2771 <= resize(setup_bump_unit_z_n2770, 26) + signed(setup_bump_unit_z_n2771_term) + setup_bump_unit_z_n2767(0);
    setup_bump_unit_z_n2772 <= setup_bump_unit_z_n2771(23 downto 0);
    setup_bump_unit_z_n2773 <= unsigned(setup_bump_unit_z_n2772(23 downto 23));
    setup_bump_unit_z_n2774 <= setup_bump_unit_z_n2773 xor setup_light_length_n42;
    setup_bump_unit_z_n2775 <= unsigned(setup_bump_unit_z_n2772);
    setup_bump_unit_z_n2776 <= setup_bump_unit_z_n2775 & setup_light_length_n43;
    setup_bump_unit_z_n2777 <= signed(setup_bump_unit_z_n2776);
    setup_bump_unit_z_n2819 <= setup_bump_unit_z_n2818_s17 & setup_bump_unit_z_n2767;
    setup_bump_unit_z_n2820 <= setup_bump_unit_z_n2819 & setup_bump_unit_z_n2774;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_unit_x_n344_s18 <= setup_light_unit_x_n344_s17;
                setup_light_unit_x_n429_s18 <= setup_light_unit_x_n429;
                setup_light_unit_x_n432_s18 <= setup_light_unit_x_n432;
                setup_light_unit_x_n535_s18 <= setup_light_unit_x_n535;
                setup_light_unit_x_n553_s18 <= setup_light_unit_x_n553_s17;
                setup_light_unit_x_n555_s18 <= setup_light_unit_x_n555_s17;
                setup_light_unit_x_n557_s18 <= setup_light_unit_x_n557_s17;
                setup_light_unit_y_n644_s18 <= setup_light_unit_y_n644;
                setup_light_unit_y_n647_s18 <= setup_light_unit_y_n647;
                setup_light_unit_y_n750_s18 <= setup_light_unit_y_n750;
                setup_light_unit_y_n767_s18 <= setup_light_unit_y_n767_s17;
                setup_light_unit_y_n769_s18 <= setup_light_unit_y_n769_s17;
                setup_light_unit_y_n771_s18 <= setup_light_unit_y_n771_s17;
                setup_light_unit_z_n858_s18 <= setup_light_unit_z_n858;
                setup_light_unit_z_n861_s18 <= setup_light_unit_z_n861;
                setup_light_unit_z_n964_s18 <= setup_light_unit_z_n964;
                setup_light_unit_z_n981_s18 <= setup_light_unit_z_n981_s17;
                setup_light_unit_z_n983_s18 <= setup_light_unit_z_n983_s17;
                setup_light_unit_z_n985_s18 <= setup_light_unit_z_n985_s17;
                setup_half_unit_x_n1311_s18 <= setup_half_unit_x_n1311_s17;
                setup_half_unit_x_n1394_s18 <= setup_half_unit_x_n1394;
                setup_half_unit_x_n1397_s18 <= setup_half_unit_x_n1397;
                setup_half_unit_x_n1500_s18 <= setup_half_unit_x_n1500;
                setup_half_unit_x_n1518_s18 <= setup_half_unit_x_n1518_s17;
                setup_half_unit_x_n1520_s18 <= setup_half_unit_x_n1520_s17;
                setup_half_unit_x_n1522_s18 <= setup_half_unit_x_n1522_s17;
                setup_half_unit_y_n1609_s18 <= setup_half_unit_y_n1609;
                setup_half_unit_y_n1612_s18 <= setup_half_unit_y_n1612;
                setup_half_unit_y_n1715_s18 <= setup_half_unit_y_n1715;
                setup_half_unit_y_n1732_s18 <= setup_half_unit_y_n1732_s17;
                setup_half_unit_y_n1734_s18 <= setup_half_unit_y_n1734_s17;
                setup_half_unit_y_n1736_s18 <= setup_half_unit_y_n1736_s17;
                setup_half_unit_z_n1823_s18 <= setup_half_unit_z_n1823;
                setup_half_unit_z_n1826_s18 <= setup_half_unit_z_n1826;
                setup_half_unit_z_n1929_s18 <= setup_half_unit_z_n1929;
                setup_half_unit_z_n1946_s18 <= setup_half_unit_z_n1946_s17;
                setup_half_unit_z_n1948_s18 <= setup_half_unit_z_n1948_s17;
                setup_half_unit_z_n1950_s18 <= setup_half_unit_z_n1950_s17;
                setup_bump_unit_x_n2216_s18 <= setup_bump_unit_x_n2216_s17;
                setup_bump_unit_x_n2361_s18 <= setup_bump_unit_x_n2361;
                setup_bump_unit_x_n2364_s18 <= setup_bump_unit_x_n2364;
                setup_bump_unit_x_n2407_s18 <= setup_bump_unit_x_n2407;
                setup_bump_unit_x_n2415_s18 <= setup_bump_unit_x_n2415_s17;
                setup_bump_unit_x_n2417_s18 <= setup_bump_unit_x_n2417_s17;
                setup_bump_unit_x_n2419_s18 <= setup_bump_unit_x_n2419_s17;
                setup_bump_unit_y_n2568_s18 <= setup_bump_unit_y_n2568;
                setup_bump_unit_y_n2571_s18 <= setup_bump_unit_y_n2571;
                setup_bump_unit_y_n2614_s18 <= setup_bump_unit_y_n2614;
                setup_bump_unit_y_n2621_s18 <= setup_bump_unit_y_n2621_s17;
                setup_bump_unit_y_n2623_s18 <= setup_bump_unit_y_n2623_s17;
                setup_bump_unit_y_n2625_s18 <= setup_bump_unit_y_n2625_s17;
                setup_bump_unit_z_n2774_s18 <= setup_bump_unit_z_n2774;
                setup_bump_unit_z_n2777_s18 <= setup_bump_unit_z_n2777;
                setup_bump_unit_z_n2820_s18 <= setup_bump_unit_z_n2820;
                setup_bump_unit_z_n2827_s18 <= setup_bump_unit_z_n2827_s17;
                setup_bump_unit_z_n2829_s18 <= setup_bump_unit_z_n2829_s17;
                setup_bump_unit_z_n2831_s18 <= setup_bump_unit_z_n2831_s17;
            end if;
            if rst = '1' then
                valid_s18 <= '0';
            elsif ce = '1' then
                valid_s18 <= valid_s17;
            end if;
        end if;
    end process;

    -- ---- stage 18 ----
    -- setup.light.unit_x
    setup_light_unit_x_n433_term <= resize(setup_light_unit_x_n344_s18, 26) xor (25 downto 0 => setup_light_unit_x_n429_s18(0));
    setup_light_unit_x_n433 <= resize(setup_light_unit_x_n432_s18, 26) + signed(setup_light_unit_x_n433_term) + setup_light_unit_x_n429_s18(0);
    setup_light_unit_x_n434 <= setup_light_unit_x_n433(23 downto 0);
    setup_light_unit_x_n435 <= unsigned(setup_light_unit_x_n434(23 downto 23));
    setup_light_unit_x_n436 <= setup_light_unit_x_n435 xor setup_light_length_n42;
    setup_light_unit_x_n437 <= unsigned(setup_light_unit_x_n434);
    setup_light_unit_x_n438 <= setup_light_unit_x_n437 & setup_light_length_n43;
    setup_light_unit_x_n439 <= signed(setup_light_unit_x_n438);
    setup_light_unit_x_n440_term <= resize(setup_light_unit_x_n344_s18, 26) xor (25 downto 0 => setup_light_unit_x_n436(0));
    setup_light_unit_x_n440 <= resize(setup_light_unit_x_n439, 26) + signed(setup_light_unit_x_n440_term) + setup_light_unit_x_n436(0);
    setup_light_unit_x_n441 <= setup_light_unit_x_n440(23 downto 0);
    setup_light_unit_x_n442 <= unsigned(setup_light_unit_x_n441(23 downto 23));
    setup_light_unit_x_n443 <= setup_light_unit_x_n442 xor setup_light_length_n42;
    setup_light_unit_x_n444 <= unsigned(setup_light_unit_x_n441);
    setup_light_unit_x_n445 <= setup_light_unit_x_n444 & setup_light_length_n43;
    setup_light_unit_x_n446 <= signed(setup_light_unit_x_n445);
    setup_light_unit_x_n536 <= setup_light_unit_x_n535_s18 & setup_light_unit_x_n436;
    setup_light_unit_x_n537 <= setup_light_unit_x_n536 & setup_light_unit_x_n443;
    -- setup.light.unit_y
    setup_light_unit_y_n648_term <= resize(setup_light_unit_x_n344_s18, 26) xor (25 downto 0 => setup_light_unit_y_n644_s18(0));
    setup_light_unit_y_n648 <= resize(setup_light_unit_y_n647_s18, 26) + signed(setup_light_unit_y_n648_term) + setup_light_unit_y_n644_s18(0);
    setup_light_unit_y_n649 <= setup_light_unit_y_n648(23 downto 0);
    setup_light_unit_y_n650 <= unsigned(setup_light_unit_y_n649(23 downto 23));
    setup_light_unit_y_n651 <= setup_light_unit_y_n650 xor setup_light_length_n42;
    setup_light_unit_y_n652 <= unsigned(setup_light_unit_y_n649);
    setup_light_unit_y_n653 <= setup_light_unit_y_n652 & setup_light_length_n43;
    setup_light_unit_y_n654 <= signed(setup_light_unit_y_n653);
    setup_light_unit_y_n655_term <= resize(setup_light_unit_x_n344_s18, 26) xor (25 downto 0 => setup_light_unit_y_n651(0));
    setup_light_unit_y_n655 <= resize(setup_light_unit_y_n654, 26) + signed(setup_light_unit_y_n655_term) + setup_light_unit_y_n651(0);
    setup_light_unit_y_n656 <= setup_light_unit_y_n655(23 downto 0);
    setup_light_unit_y_n657 <= unsigned(setup_light_unit_y_n656(23 downto 23));
    setup_light_unit_y_n658 <= setup_light_unit_y_n657 xor setup_light_length_n42;
    setup_light_unit_y_n659 <= unsigned(setup_light_unit_y_n656);
    setup_light_unit_y_n660 <= setup_light_unit_y_n659 & setup_light_length_n43;
    setup_light_unit_y_n661 <= signed(setup_light_unit_y_n660);
    setup_light_unit_y_n751 <= setup_light_unit_y_n750_s18 & setup_light_unit_y_n651;
    setup_light_unit_y_n752 <= setup_light_unit_y_n751 & setup_light_unit_y_n658;
    -- setup.light.unit_z
    setup_light_unit_z_n862_term <= resize(setup_light_unit_x_n344_s18, 26) xor (25 downto 0 => setup_light_unit_z_n858_s18(0));
    setup_light_unit_z_n862 <= resize(setup_light_unit_z_n861_s18, 26) + signed(setup_light_unit_z_n862_term) + setup_light_unit_z_n858_s18(0);
    setup_light_unit_z_n863 <= setup_light_unit_z_n862(23 downto 0);
    setup_light_unit_z_n864 <= unsigned(setup_light_unit_z_n863(23 downto 23));
    setup_light_unit_z_n865 <= setup_light_unit_z_n864 xor setup_light_length_n42;
    setup_light_unit_z_n866 <= unsigned(setup_light_unit_z_n863);
    setup_light_unit_z_n867 <= setup_light_unit_z_n866 & setup_light_length_n43;
    setup_light_unit_z_n868 <= signed(setup_light_unit_z_n867);
    setup_light_unit_z_n869_term <= resize(setup_light_unit_x_n344_s18, 26) xor (25 downto 0 => setup_light_unit_z_n865(0));
    setup_light_unit_z_n869 <= resize(setup_light_unit_z_n868, 26) + signed(setup_light_unit_z_n869_term) + setup_light_unit_z_n865(0);
    setup_light_unit_z_n870 <= setup_light_unit_z_n869(23 downto 0);
    setup_light_unit_z_n871 <= unsigned(setup_light_unit_z_n870(23 downto 23));
    setup_light_unit_z_n872 <= setup_light_unit_z_n871 xor setup_light_length_n42;
    setup_light_unit_z_n873 <= unsigned(setup_light_unit_z_n870);
    setup_light_unit_z_n874 <= setup_light_unit_z_n873 & setup_light_length_n43;
    setup_light_unit_z_n875 <= signed(setup_light_unit_z_n874);
    setup_light_unit_z_n965 <= setup_light_unit_z_n964_s18 & setup_light_unit_z_n865;
    setup_light_unit_z_n966 <= setup_light_unit_z_n965 & setup_light_unit_z_n872;
    -- setup.half.unit_x
    setup_half_unit_x_n1398_term <= resize(setup_half_unit_x_n1311_s18, 26) xor (25 downto 0 => setup_half_unit_x_n1394_s18(0));
    setup_half_unit_x_n1398 <= resize(setup_half_unit_x_n1397_s18, 26) + signed(setup_half_unit_x_n1398_term) + setup_half_unit_x_n1394_s18(0);
    setup_half_unit_x_n1399 <= setup_half_unit_x_n1398(23 downto 0);
    setup_half_unit_x_n1400 <= unsigned(setup_half_unit_x_n1399(23 downto 23));
    setup_half_unit_x_n1401 <= setup_half_unit_x_n1400 xor setup_light_length_n42;
    setup_half_unit_x_n1402 <= unsigned(setup_half_unit_x_n1399);
    setup_half_unit_x_n1403 <= setup_half_unit_x_n1402 & setup_light_length_n43;
    setup_half_unit_x_n1404 <= signed(setup_half_unit_x_n1403);
    setup_half_unit_x_n1405_term <= resize(setup_half_unit_x_n1311_s18, 26) xor (25 downto 0 => setup_half_unit_x_n1401(0));
    setup_half_unit_x_n1405 <= resize(setup_half_unit_x_n1404, 26) + signed(setup_half_unit_x_n1405_term) + setup_half_unit_x_n1401(0);
    setup_half_unit_x_n1406 <= setup_half_unit_x_n1405(23 downto 0);
    setup_half_unit_x_n1407 <= unsigned(setup_half_unit_x_n1406(23 downto 23));
    setup_half_unit_x_n1408 <= setup_half_unit_x_n1407 xor setup_light_length_n42;
    setup_half_unit_x_n1409 <= unsigned(setup_half_unit_x_n1406);
    setup_half_unit_x_n1410 <= setup_half_unit_x_n1409 & setup_light_length_n43;
    setup_half_unit_x_n1411 <= signed(setup_half_unit_x_n1410);
    setup_half_unit_x_n1501 <= setup_half_unit_x_n1500_s18 & setup_half_unit_x_n1401;
    setup_half_unit_x_n1502 <= setup_half_unit_x_n1501 & setup_half_unit_x_n1408;
    -- setup.half.unit_y
    setup_half_unit_y_n1613_term <= resize(setup_half_unit_x_n1311_s18, 26) xor (25 downto 0 => setup_half_unit_y_n1609_s18(0));
    setup_half_unit_y_n1613 <= resize(setup_half_unit_y_n1612_s18, 26) + signed(setup_half_unit_y_n1613_term) + setup_half_unit_y_n1609_s18(0);
    setup_half_unit_y_n1614 <= setup_half_unit_y_n1613(23 downto 0);
    setup_half_unit_y_n1615 <= unsigned(setup_half_unit_y_n1614(23 downto 23));
    setup_half_unit_y_n1616 <= setup_half_unit_y_n1615 xor setup_light_length_n42;
    setup_half_unit_y_n1617 <= unsigned(setup_half_unit_y_n1614);
    setup_half_unit_y_n1618 <= setup_half_unit_y_n1617 & setup_light_length_n43;
    setup_half_unit_y_n1619 <= signed(setup_half_unit_y_n1618);
    setup_half_unit_y_n1620_term <= resize(setup_half_unit_x_n1311_s18, 26) xor (25 downto 0 => setup_half_unit_y_n1616(0));
    setup_half_unit_y_n1620 <= resize(setup_half_unit_y_n1619, 26) + signed(setup_half_unit_y_n1620_term) + setup_half_unit_y_n1616(0);
    setup_half_unit_y_n1621 <= setup_half_unit_y_n1620(23 downto 0);
    setup_half_unit_y_n1622 <= unsigned(setup_half_unit_y_n1621(23 downto 23));
    setup_half_unit_y_n1623 <= setup_half_unit_y_n1622 xor setup_light_length_n42;
    setup_half_unit_y_n1624 <= unsigned(setup_half_unit_y_n1621);
    setup_half_unit_y_n1625 <= setup_half_unit_y_n1624 & setup_light_length_n43;
    setup_half_unit_y_n1626 <= signed(setup_half_unit_y_n1625);
    setup_half_unit_y_n1716 <= setup_half_unit_y_n1715_s18 & setup_half_unit_y_n1616;
    setup_half_unit_y_n1717 <= setup_half_unit_y_n1716 & setup_half_unit_y_n1623;
    -- setup.half.unit_z
    setup_half_unit_z_n1827_term <= resize(setup_half_unit_x_n1311_s18, 26) xor (25 downto 0 => setup_half_unit_z_n1823_s18(0));
    setup_half_unit_z_n1827 <= resize(setup_half_unit_z_n1826_s18, 26) + signed(setup_half_unit_z_n1827_term) + setup_half_unit_z_n1823_s18(0);
    setup_half_unit_z_n1828 <= setup_half_unit_z_n1827(23 downto 0);
    setup_half_unit_z_n1829 <= unsigned(setup_half_unit_z_n1828(23 downto 23));
    setup_half_unit_z_n1830 <= setup_half_unit_z_n1829 xor setup_light_length_n42;
    setup_half_unit_z_n1831 <= unsigned(setup_half_unit_z_n1828);
    setup_half_unit_z_n1832 <= setup_half_unit_z_n1831 & setup_light_length_n43;
    setup_half_unit_z_n1833 <= signed(setup_half_unit_z_n1832);
    setup_half_unit_z_n1834_term <= resize(setup_half_unit_x_n1311_s18, 26) xor (25 downto 0 => setup_half_unit_z_n1830(0));
    setup_half_unit_z_n1834 <= resize(setup_half_unit_z_n1833, 26) + signed(setup_half_unit_z_n1834_term) + setup_half_unit_z_n1830(0);
    setup_half_unit_z_n1835 <= setup_half_unit_z_n1834(23 downto 0);
    setup_half_unit_z_n1836 <= unsigned(setup_half_unit_z_n1835(23 downto 23));
    setup_half_unit_z_n1837 <= setup_half_unit_z_n1836 xor setup_light_length_n42;
    setup_half_unit_z_n1838 <= unsigned(setup_half_unit_z_n1835);
    setup_half_unit_z_n1839 <= setup_half_unit_z_n1838 & setup_light_length_n43;
    setup_half_unit_z_n1840 <= signed(setup_half_unit_z_n1839);
    setup_half_unit_z_n1930 <= setup_half_unit_z_n1929_s18 & setup_half_unit_z_n1830;
    setup_half_unit_z_n1931 <= setup_half_unit_z_n1930 & setup_half_unit_z_n1837;
    -- setup.bump.unit_x
    setup_bump_unit_x_n2365_term <= resize(setup_bump_unit_x_n2216_s18, 26) xor (25 downto 0 => setup_bump_unit_x_n2361_s18(0));
    setup_bump_unit_x_n2365 <= resize(setup_bump_unit_x_n2364_s18, 26) + signed(setup_bump_unit_x_n2365_term) + setup_bump_unit_x_n2361_s18(0);
    setup_bump_unit_x_n2366 <= setup_bump_unit_x_n2365(23 downto 0);
    setup_bump_unit_x_n2367 <= unsigned(setup_bump_unit_x_n2366(23 downto 23));
    setup_bump_unit_x_n2368 <= setup_bump_unit_x_n2367 xor setup_light_length_n42;
    setup_bump_unit_x_n2369 <= unsigned(setup_bump_unit_x_n2366);
    setup_bump_unit_x_n2370 <= setup_bump_unit_x_n2369 & setup_light_length_n43;
    setup_bump_unit_x_n2371 <= signed(setup_bump_unit_x_n2370);
    setup_bump_unit_x_n2372_term <= resize(setup_bump_unit_x_n2216_s18, 26) xor (25 downto 0 => setup_bump_unit_x_n2368(0));
    setup_bump_unit_x_n2372 <= resize(setup_bump_unit_x_n2371, 26) + signed(setup_bump_unit_x_n2372_term) + setup_bump_unit_x_n2368(0);
    setup_bump_unit_x_n2373 <= setup_bump_unit_x_n2372(23 downto 0);
    setup_bump_unit_x_n2374 <= unsigned(setup_bump_unit_x_n2373(23 downto 23));
    setup_bump_unit_x_n2375 <= setup_bump_unit_x_n2374 xor setup_light_length_n42;
    setup_bump_unit_x_n2376 <= unsigned(setup_bump_unit_x_n2373);
    setup_bump_unit_x_n2377 <= setup_bump_unit_x_n2376 & setup_light_length_n43;
    setup_bump_unit_x_n2378 <= signed(setup_bump_unit_x_n2377);
    setup_bump_unit_x_n2408 <= setup_bump_unit_x_n2407_s18 & setup_bump_unit_x_n2368;
    setup_bump_unit_x_n2409 <= setup_bump_unit_x_n2408 & setup_bump_unit_x_n2375;
    -- setup.bump.unit_y
    setup_bump_unit_y_n2572_term <= resize(setup_bump_unit_x_n2216_s18, 26) xor (25 downto 0 => setup_bump_unit_y_n2568_s18(0));
    setup_bump_unit_y_n2572 <= resize(setup_bump_unit_y_n2571_s18, 26) + signed(setup_bump_unit_y_n2572_term) + setup_bump_unit_y_n2568_s18(0);
    setup_bump_unit_y_n2573 <= setup_bump_unit_y_n2572(23 downto 0);
    setup_bump_unit_y_n2574 <= unsigned(setup_bump_unit_y_n2573(23 downto 23));
    setup_bump_unit_y_n2575 <= setup_bump_unit_y_n2574 xor setup_light_length_n42;
    setup_bump_unit_y_n2576 <= unsigned(setup_bump_unit_y_n2573);
    setup_bump_unit_y_n2577 <= setup_bump_unit_y_n2576 & setup_light_length_n43;
    setup_bump_unit_y_n2578 <= signed(setup_bump_unit_y_n2577);
    setup_bump_unit_y_n2579_term <= resize(setup_bump_unit_x_n2216_s18, 26) xor (25 downto 0 => setup_bump_unit_y_n2575(0));
    setup_bump_unit_y_n2579 <= resize(setup_bump_unit_y_n2578, 26) + signed(setup_bump_unit_y_n2579_term) + setup_bump_unit_y_n2575(0);
    setup_bump_unit_y_n2580 <= setup_bump_unit_y_n2579(23 downto 0);
    setup_bump_unit_y_n2581 <= unsigned(setup_bump_unit_y_n2580(23 downto 23));
    setup_bump_unit_y_n2582 <= setup_bump_unit_y_n2581 xor setup_light_length_n42;
    setup_bump_unit_y_n2583 <= unsigned(setup_bump_unit_y_n2580);
    setup_bump_unit_y_n2584 <= setup_bump_unit_y_n2583 & setup_light_length_n43;
    setup_bump_unit_y_n2585 <= signed(setup_bump_unit_y_n2584);
    setup_bump_unit_y_n2615 <= setup_bump_unit_y_n2614_s18 & setup_bump_unit_y_n2575;
    setup_bump_unit_y_n2616 <= setup_bump_unit_y_n2615 & setup_bump_unit_y_n2582;
    -- setup.bump.unit_z
    setup_bump_unit_z_n2778_term <= resize(setup_bump_unit_x_n2216_s18, 26) xor (25 downto 0 => setup_bump_unit_z_n2774_s18(0));
    setup_bump_unit_z_n2778 <= resize(setup_bump_unit_z_n2777_s18, 26) + signed(setup_bump_unit_z_n2778_term) + setup_bump_unit_z_n2774_s18(0);
    setup_bump_unit_z_n2779 <= setup_bump_unit_z_n2778(23 downto 0);
    setup_bump_unit_z_n2780 <= unsigned(setup_bump_unit_z_n2779(23 downto 23));
    setup_bump_unit_z_n2781 <= setup_bump_unit_z_n2780 xor setup_light_length_n42;
    setup_bump_unit_z_n2782 <= unsigned(setup_bump_unit_z_n2779);
    setup_bump_unit_z_n2783 <= setup_bump_unit_z_n2782 & setup_light_length_n43;
    setup_bump_unit_z_n2784 <= signed(setup_bump_unit_z_n2783);
    setup_bump_unit_z_n2785_term <= resize(setup_bump_unit_x_n2216_s18, 26) xor (25 downto 0 => setup_bump_unit_z_n2781(0));
    setup_bump_unit_z_n2785 <= resize(setup_bump_unit_z_n2784, 26) + signed(setup_bump_unit_z_n2785_term) + setup_bump_unit_z_n2781(0);
    setup_bump_unit_z_n2786 <= setup_bump_unit_z_n2785(23 downto 0);
    setup_bump_unit_z_n2787 <= unsigned(setup_bump_unit_z_n2786(23 downto 23));
    setup_bump_unit_z_n2788 <= setup_bump_unit_z_n2787 xor setup_light_length_n42;
    setup_bump_unit_z_n2789 <= unsigned(setup_bump_unit_z_n2786);
    setup_bump_unit_z_n2790 <= setup_bump_unit_z_n2789 & setup_light_length_n43;
    setup_bump_unit_z_n2791 <= signed(setup_bump_unit_z_n2790);
    setup_bump_unit_z_n2821 <= setup_bump_unit_z_n2820_s18 & setup_bump_unit_z_n2781;
    setup_bump_unit_z_n2822 <= setup_bump_unit_z_n2821 & setup_bump_unit_z_n2788;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_unit_x_n344_s19 <= setup_light_unit_x_n344_s18;
                setup_light_unit_x_n443_s19 <= setup_light_unit_x_n443;
                setup_light_unit_x_n446_s19 <= setup_light_unit_x_n446;
                setup_light_unit_x_n537_s19 <= setup_light_unit_x_n537;
                setup_light_unit_x_n553_s19 <= setup_light_unit_x_n553_s18;
                setup_light_unit_x_n555_s19 <= setup_light_unit_x_n555_s18;
                setup_light_unit_x_n557_s19 <= setup_light_unit_x_n557_s18;
                setup_light_unit_y_n658_s19 <= setup_light_unit_y_n658;
                setup_light_unit_y_n661_s19 <= setup_light_unit_y_n661;
                setup_light_unit_y_n752_s19 <= setup_light_unit_y_n752;
                setup_light_unit_y_n767_s19 <= setup_light_unit_y_n767_s18;
                setup_light_unit_y_n769_s19 <= setup_light_unit_y_n769_s18;
                setup_light_unit_y_n771_s19 <= setup_light_unit_y_n771_s18;
                setup_light_unit_z_n872_s19 <= setup_light_unit_z_n872;
                setup_light_unit_z_n875_s19 <= setup_light_unit_z_n875;
                setup_light_unit_z_n966_s19 <= setup_light_unit_z_n966;
                setup_light_unit_z_n981_s19 <= setup_light_unit_z_n981_s18;
                setup_light_unit_z_n983_s19 <= setup_light_unit_z_n983_s18;
                setup_light_unit_z_n985_s19 <= setup_light_unit_z_n985_s18;
                setup_half_unit_x_n1311_s19 <= setup_half_unit_x_n1311_s18;
                setup_half_unit_x_n1408_s19 <= setup_half_unit_x_n1408;
                setup_half_unit_x_n1411_s19 <= setup_half_unit_x_n1411;
                setup_half_unit_x_n1502_s19 <= setup_half_unit_x_n1502;
                setup_half_unit_x_n1518_s19 <= setup_half_unit_x_n1518_s18;
                setup_half_unit_x_n1520_s19 <= setup_half_unit_x_n1520_s18;
                setup_half_unit_x_n1522_s19 <= setup_half_unit_x_n1522_s18;
                setup_half_unit_y_n1623_s19 <= setup_half_unit_y_n1623;
                setup_half_unit_y_n1626_s19 <= setup_half_unit_y_n1626;
                setup_half_unit_y_n1717_s19 <= setup_half_unit_y_n1717;
                setup_half_unit_y_n1732_s19 <= setup_half_unit_y_n1732_s18;
                setup_half_unit_y_n1734_s19 <= setup_half_unit_y_n1734_s18;
                setup_half_unit_y_n1736_s19 <= setup_half_unit_y_n1736_s18;
                setup_half_unit_z_n1837_s19 <= setup_half_unit_z_n1837;
                setup_half_unit_z_n1840_s19 <= setup_half_unit_z_n1840;
                setup_half_unit_z_n1931_s19 <= setup_half_unit_z_n1931;
                setup_half_unit_z_n1946_s19 <= setup_half_unit_z_n1946_s18;
                setup_half_unit_z_n1948_s19 <= setup_half_unit_z_n1948_s18;
                setup_half_unit_z_n1950_s19 <= setup_half_unit_z_n1950_s18;
                setup_bump_unit_x_n2216_s19 <= setup_bump_unit_x_n2216_s18;
                setup_bump_unit_x_n2375_s19 <= setup_bump_unit_x_n2375;
                setup_bump_unit_x_n2378_s19 <= setup_bump_unit_x_n2378;
                setup_bump_unit_x_n2409_s19 <= setup_bump_unit_x_n2409;
                setup_bump_unit_x_n2415_s19 <= setup_bump_unit_x_n2415_s18;
                setup_bump_unit_x_n2417_s19 <= setup_bump_unit_x_n2417_s18;
                setup_bump_unit_x_n2419_s19 <= setup_bump_unit_x_n2419_s18;
                setup_bump_unit_y_n2582_s19 <= setup_bump_unit_y_n2582;
                setup_bump_unit_y_n2585_s19 <= setup_bump_unit_y_n2585;
                setup_bump_unit_y_n2616_s19 <= setup_bump_unit_y_n2616;
                setup_bump_unit_y_n2621_s19 <= setup_bump_unit_y_n2621_s18;
                setup_bump_unit_y_n2623_s19 <= setup_bump_unit_y_n2623_s18;
                setup_bump_unit_y_n2625_s19 <= setup_bump_unit_y_n2625_s18;
                setup_bump_unit_z_n2788_s19 <= setup_bump_unit_z_n2788;
                setup_bump_unit_z_n2791_s19 <= setup_bump_unit_z_n2791;
                setup_bump_unit_z_n2822_s19 <= setup_bump_unit_z_n2822;
                setup_bump_unit_z_n2827_s19 <= setup_bump_unit_z_n2827_s18;
                setup_bump_unit_z_n2829_s19 <= setup_bump_unit_z_n2829_s18;
                setup_bump_unit_z_n2831_s19 <= setup_bump_unit_z_n2831_s18;
            end if;
            if rst = '1' then
                valid_s19 <= '0';
            elsif ce = '1' then
                valid_s19 <= valid_s18;
            end if;
        end if;
    end process;

    -- ---- stage 19 ----
    -- setup.light.unit_x
    setup_light_unit_x_n447_term <= resize(setup_light_unit_x_n344_s19, 26) xor (25 downto 0 => setup_light_unit_x_n443_s19(0));
    setup_light_unit_x_n447 <= resize(setup_light_unit_x_n446_s19, 26) + signed(setup_light_unit_x_n447_term) + setup_light_unit_x_n443_s19(0);
    setup_light_unit_x_n448 <= setup_light_unit_x_n447(23 downto 0);
    setup_light_unit_x_n449 <= unsigned(setup_light_unit_x_n448(23 downto 23));
    setup_light_unit_x_n450 <= setup_light_unit_x_n449 xor setup_light_length_n42;
    setup_light_unit_x_n451 <= unsigned(setup_light_unit_x_n448);
    setup_light_unit_x_n452 <= setup_light_unit_x_n451 & setup_light_length_n43;
    setup_light_unit_x_n453 <= signed(setup_light_unit_x_n452);
    setup_light_unit_x_n454_term <= resize(setup_light_unit_x_n344_s19, 26) xor (25 downto 0 => setup_light_unit_x_n450(0));
    setup_light_unit_x_n454 <= resize(setup_light_unit_x_n453, 26) + signed(setup_light_unit_x_n454_term) + setup_light_unit_x_n450(0);
    setup_light_unit_x_n455 <= setup_light_unit_x_n454(23 downto 0);
    setup_light_unit_x_n456 <= unsigned(setup_light_unit_x_n455(23 downto 23));
    setup_light_unit_x_n457 <= setup_light_unit_x_n456 xor setup_light_length_n42;
    setup_light_unit_x_n458 <= unsigned(setup_light_unit_x_n455);
    setup_light_unit_x_n459 <= setup_light_unit_x_n458 & setup_light_length_n43;
    setup_light_unit_x_n460 <= signed(setup_light_unit_x_n459);
    setup_light_unit_x_n538 <= setup_light_unit_x_n537_s19 & setup_light_unit_x_n450;
    setup_light_unit_x_n539 <= setup_light_unit_x_n538 & setup_light_unit_x_n457;
    -- setup.light.unit_y
    setup_light_unit_y_n662_term <= resize(setup_light_unit_x_n344_s19, 26) xor (25 downto 0 => setup_light_unit_y_n658_s19(0));
    setup_light_unit_y_n662 <= resize(setup_light_unit_y_n661_s19, 26) + signed(setup_light_unit_y_n662_term) + setup_light_unit_y_n658_s19(0);
    setup_light_unit_y_n663 <= setup_light_unit_y_n662(23 downto 0);
    setup_light_unit_y_n664 <= unsigned(setup_light_unit_y_n663(23 downto 23));
    setup_light_unit_y_n665 <= setup_light_unit_y_n664 xor setup_light_length_n42;
    setup_light_unit_y_n666 <= unsigned(setup_light_unit_y_n663);
    setup_light_unit_y_n667 <= setup_light_unit_y_n666 & setup_light_length_n43;
    setup_light_unit_y_n668 <= signed(setup_light_unit_y_n667);
    setup_light_unit_y_n669_term <= resize(setup_light_unit_x_n344_s19, 26) xor (25 downto 0 => setup_light_unit_y_n665(0));
    setup_light_unit_y_n669 <= resize(setup_light_unit_y_n668, 26) + signed(setup_light_unit_y_n669_term) + setup_light_unit_y_n665(0);
    setup_light_unit_y_n670 <= setup_light_unit_y_n669(23 downto 0);
    setup_light_unit_y_n671 <= unsigned(setup_light_unit_y_n670(23 downto 23));
    setup_light_unit_y_n672 <= setup_light_unit_y_n671 xor setup_light_length_n42;
    setup_light_unit_y_n673 <= unsigned(setup_light_unit_y_n670);
    setup_light_unit_y_n674 <= setup_light_unit_y_n673 & setup_light_length_n43;
    setup_light_unit_y_n675 <= signed(setup_light_unit_y_n674);
    setup_light_unit_y_n753 <= setup_light_unit_y_n752_s19 & setup_light_unit_y_n665;
    setup_light_unit_y_n754 <= setup_light_unit_y_n753 & setup_light_unit_y_n672;
    -- setup.light.unit_z
    setup_light_unit_z_n876_term <= resize(setup_light_unit_x_n344_s19, 26) xor (25 downto 0 => setup_light_unit_z_n872_s19(0));
    setup_light_unit_z_n876 <= resize(setup_light_unit_z_n875_s19, 26) + signed(setup_light_unit_z_n876_term) + setup_light_unit_z_n872_s19(0);
    setup_light_unit_z_n877 <= setup_light_unit_z_n876(23 downto 0);
    setup_light_unit_z_n878 <= unsigned(setup_light_unit_z_n877(23 downto 23));
    setup_light_unit_z_n879 <= setup_light_unit_z_n878 xor setup_light_length_n42;
    setup_light_unit_z_n880 <= unsigned(setup_light_unit_z_n877);
    setup_light_unit_z_n881 <= setup_light_unit_z_n880 & setup_light_length_n43;
    setup_light_unit_z_n882 <= signed(setup_light_unit_z_n881);
    setup_light_unit_z_n883_term <= resize(setup_light_unit_x_n344_s19, 26) xor (25 downto 0 => setup_light_unit_z_n879(0));
    setup_light_unit_z_n883 <= resize(setup_light_unit_z_n882, 26) + signed(setup_light_unit_z_n883_term) + setup_light_unit_z_n879(0);
    setup_light_unit_z_n884 <= setup_light_unit_z_n883(23 downto 0);
    setup_light_unit_z_n885 <= unsigned(setup_light_unit_z_n884(23 downto 23));
    setup_light_unit_z_n886 <= setup_light_unit_z_n885 xor setup_light_length_n42;
    setup_light_unit_z_n887 <= unsigned(setup_light_unit_z_n884);
    setup_light_unit_z_n888 <= setup_light_unit_z_n887 & setup_light_length_n43;
    setup_light_unit_z_n889 <= signed(setup_light_unit_z_n888);
    setup_light_unit_z_n967 <= setup_light_unit_z_n966_s19 & setup_light_unit_z_n879;
    setup_light_unit_z_n968 <= setup_light_unit_z_n967 & setup_light_unit_z_n886;
    -- setup.half.unit_x
    setup_half_unit_x_n1412_term <= resize(setup_half_unit_x_n1311_s19, 26) xor (25 downto 0 => setup_half_unit_x_n1408_s19(0));
    setup_half_unit_x_n1412 <= resize(setup_half_unit_x_n1411_s19, 26) + signed(setup_half_unit_x_n1412_term) + setup_half_unit_x_n1408_s19(0);
    setup_half_unit_x_n1413 <= setup_half_unit_x_n1412(23 downto 0);
    setup_half_unit_x_n1414 <= unsigned(setup_half_unit_x_n1413(23 downto 23));
    setup_half_unit_x_n1415 <= setup_half_unit_x_n1414 xor setup_light_length_n42;
    setup_half_unit_x_n1416 <= unsigned(setup_half_unit_x_n1413);
    setup_half_unit_x_n1417 <= setup_half_unit_x_n1416 & setup_light_length_n43;
    setup_half_unit_x_n1418 <= signed(setup_half_unit_x_n1417);
    setup_half_unit_x_n1419_term <= resize(setup_half_unit_x_n1311_s19, 26) xor (25 downto 0 => setup_half_unit_x_n1415(0));
    setup_half_unit_x_n1419 <= resize(setup_half_unit_x_n1418, 26) + signed(setup_half_unit_x_n1419_term) + setup_half_unit_x_n1415(0);
    setup_half_unit_x_n1420 <= setup_half_unit_x_n1419(23 downto 0);
    setup_half_unit_x_n1421 <= unsigned(setup_half_unit_x_n1420(23 downto 23));
    setup_half_unit_x_n1422 <= setup_half_unit_x_n1421 xor setup_light_length_n42;
    setup_half_unit_x_n1423 <= unsigned(setup_half_unit_x_n1420);
    setup_half_unit_x_n1424 <= setup_half_unit_x_n1423 & setup_light_length_n43;
    setup_half_unit_x_n1425 <= signed(setup_half_unit_x_n1424);
    setup_half_unit_x_n1503 <= setup_half_unit_x_n1502_s19 & setup_half_unit_x_n1415;
    setup_half_unit_x_n1504 <= setup_half_unit_x_n1503 & setup_half_unit_x_n1422;
    -- setup.half.unit_y
    setup_half_unit_y_n1627_term <= resize(setup_half_unit_x_n1311_s19, 26) xor (25 downto 0 => setup_half_unit_y_n1623_s19(0));
    setup_half_unit_y_n1627 <= resize(setup_half_unit_y_n1626_s19, 26) + signed(setup_half_unit_y_n1627_term) + setup_half_unit_y_n1623_s19(0);
    setup_half_unit_y_n1628 <= setup_half_unit_y_n1627(23 downto 0);
    setup_half_unit_y_n1629 <= unsigned(setup_half_unit_y_n1628(23 downto 23));
    setup_half_unit_y_n1630 <= setup_half_unit_y_n1629 xor setup_light_length_n42;
    setup_half_unit_y_n1631 <= unsigned(setup_half_unit_y_n1628);
    setup_half_unit_y_n1632 <= setup_half_unit_y_n1631 & setup_light_length_n43;
    setup_half_unit_y_n1633 <= signed(setup_half_unit_y_n1632);
    setup_half_unit_y_n1634_term <= resize(setup_half_unit_x_n1311_s19, 26) xor (25 downto 0 => setup_half_unit_y_n1630(0));
    setup_half_unit_y_n1634 <= resize(setup_half_unit_y_n1633, 26) + signed(setup_half_unit_y_n1634_term) + setup_half_unit_y_n1630(0);
    setup_half_unit_y_n1635 <= setup_half_unit_y_n1634(23 downto 0);
    setup_half_unit_y_n1636 <= unsigned(setup_half_unit_y_n1635(23 downto 23));
    setup_half_unit_y_n1637 <= setup_half_unit_y_n1636 xor setup_light_length_n42;
    setup_half_unit_y_n1638 <= unsigned(setup_half_unit_y_n1635);
    setup_half_unit_y_n1639 <= setup_half_unit_y_n1638 & setup_light_length_n43;
    setup_half_unit_y_n1640 <= signed(setup_half_unit_y_n1639);
    setup_half_unit_y_n1718 <= setup_half_unit_y_n1717_s19 & setup_half_unit_y_n1630;
    setup_half_unit_y_n1719 <= setup_half_unit_y_n1718 & setup_half_unit_y_n1637;
    -- setup.half.unit_z
    setup_half_unit_z_n1841_term <= resize(setup_half_unit_x_n1311_s19, 26) xor (25 downto 0 => setup_half_unit_z_n1837_s19(0));
    setup_half_unit_z_n1841 <= resize(setup_half_unit_z_n1840_s19, 26) + signed(setup_half_unit_z_n1841_term) + setup_half_unit_z_n1837_s19(0);
    setup_half_unit_z_n1842 <= setup_half_unit_z_n1841(23 downto 0);
    setup_half_unit_z_n1843 <= unsigned(setup_half_unit_z_n1842(23 downto 23));
    setup_half_unit_z_n1844 <= setup_half_unit_z_n1843 xor setup_light_length_n42;
    setup_half_unit_z_n1845 <= unsigned(setup_half_unit_z_n1842);
    setup_half_unit_z_n1846 <= setup_half_unit_z_n1845 & setup_light_length_n43;
    setup_half_unit_z_n1847 <= signed(setup_half_unit_z_n1846);
    setup_half_unit_z_n1848_term <= resize(setup_half_unit_x_n1311_s19, 26) xor (25 downto 0 => setup_half_unit_z_n1844(0));
    setup_half_unit_z_n1848 <= resize(setup_half_unit_z_n1847, 26) + signed(setup_half_unit_z_n1848_term) + setup_half_unit_z_n1844(0);
    setup_half_unit_z_n1849 <= setup_half_unit_z_n1848(23 downto 0);
    setup_half_unit_z_n1850 <= unsigned(setup_half_unit_z_n1849(23 downto 23));
    setup_half_unit_z_n1851 <= setup_half_unit_z_n1850 xor setup_light_length_n42;
    setup_half_unit_z_n1852 <= unsigned(setup_half_unit_z_n1849);
    setup_half_unit_z_n1853 <= setup_half_unit_z_n1852 & setup_light_length_n43;
    setup_half_unit_z_n1854 <= signed(setup_half_unit_z_n1853);
    setup_half_unit_z_n1932 <= setup_half_unit_z_n1931_s19 & setup_half_unit_z_n1844;
    setup_half_unit_z_n1933 <= setup_half_unit_z_n1932 & setup_half_unit_z_n1851;
    -- setup.bump.unit_x
    setup_bump_unit_x_n2379_term <= resize(setup_bump_unit_x_n2216_s19, 26) xor (25 downto 0 => setup_bump_unit_x_n2375_s19(0));
    setup_bump_unit_x_n2379 <= resize(setup_bump_unit_x_n2378_s19, 26) + signed(setup_bump_unit_x_n2379_term) + setup_bump_unit_x_n2375_s19(0);
    setup_bump_unit_x_n2380 <= setup_bump_unit_x_n2379(23 downto 0);
    setup_bump_unit_x_n2381 <= unsigned(setup_bump_unit_x_n2380(23 downto 23));
    setup_bump_unit_x_n2382 <= setup_bump_unit_x_n2381 xor setup_light_length_n42;
    setup_bump_unit_x_n2383 <= unsigned(setup_bump_unit_x_n2380);
    setup_bump_unit_x_n2384 <= setup_bump_unit_x_n2383 & setup_light_length_n43;
    setup_bump_unit_x_n2385 <= signed(setup_bump_unit_x_n2384);
    setup_bump_unit_x_n2386_term <= resize(setup_bump_unit_x_n2216_s19, 26) xor (25 downto 0 => setup_bump_unit_x_n2382(0));
    setup_bump_unit_x_n2386 <= resize(setup_bump_unit_x_n2385, 26) + signed(setup_bump_unit_x_n2386_term) + setup_bump_unit_x_n2382(0);
    setup_bump_unit_x_n2387 <= setup_bump_unit_x_n2386(23 downto 0);
    setup_bump_unit_x_n2388 <= unsigned(setup_bump_unit_x_n2387(23 downto 23));
    setup_bump_unit_x_n2389 <= setup_bump_unit_x_n2388 xor setup_light_length_n42;
    setup_bump_unit_x_n2390 <= resize(setup_bump_unit_x_n2387, 25) + signed(resize(setup_bump_unit_x_n2216_s19, 25));
    setup_bump_unit_x_n2410 <= setup_bump_unit_x_n2409_s19 & setup_bump_unit_x_n2382;
    setup_bump_unit_x_n2411 <= setup_bump_unit_x_n2410 & setup_bump_unit_x_n2389;
    -- setup.bump.unit_y
    setup_bump_unit_y_n2586_term <= resize(setup_bump_unit_x_n2216_s19, 26) xor (25 downto 0 => setup_bump_unit_y_n2582_s19(0));
    setup_bump_unit_y_n2586 <= resize(setup_bump_unit_y_n2585_s19, 26) + signed(setup_bump_unit_y_n2586_term) + setup_bump_unit_y_n2582_s19(0);
    setup_bump_unit_y_n2587 <= setup_bump_unit_y_n2586(23 downto 0);
    setup_bump_unit_y_n2588 <= unsigned(setup_bump_unit_y_n2587(23 downto 23));
    setup_bump_unit_y_n2589 <= setup_bump_unit_y_n2588 xor setup_light_length_n42;
    setup_bump_unit_y_n2590 <= unsigned(setup_bump_unit_y_n2587);
    setup_bump_unit_y_n2591 <= setup_bump_unit_y_n2590 & setup_light_length_n43;
    setup_bump_unit_y_n2592 <= signed(setup_bump_unit_y_n2591);
    setup_bump_unit_y_n2593_term <= resize(setup_bump_unit_x_n2216_s19, 26) xor (25 downto 0 => setup_bump_unit_y_n2589(0));
    setup_bump_unit_y_n2593 <= resize(setup_bump_unit_y_n2592, 26) + signed(setup_bump_unit_y_n2593_term) + setup_bump_unit_y_n2589(0);
    setup_bump_unit_y_n2594 <= setup_bump_unit_y_n2593(23 downto 0);
    setup_bump_unit_y_n2595 <= unsigned(setup_bump_unit_y_n2594(23 downto 23));
    setup_bump_unit_y_n2596 <= setup_bump_unit_y_n2595 xor setup_light_length_n42;
    setup_bump_unit_y_n2597 <= resize(setup_bump_unit_y_n2594, 25) + signed(resize(setup_bump_unit_x_n2216_s19, 25));
    setup_bump_unit_y_n2617 <= setup_bump_unit_y_n2616_s19 & setup_bump_unit_y_n2589;
    setup_bump_unit_y_n2618 <= setup_bump_unit_y_n2617 & setup_bump_unit_y_n2596;
    -- setup.bump.unit_z
    setup_bump_unit_z_n2792_term <= resize(setup_bump_unit_x_n2216_s19, 26) xor (25 downto 0 => setup_bump_unit_z_n2788_s19(0));
    setup_bump_unit_z_n2792 <= resize(setup_bump_unit_z_n2791_s19, 26) + signed(setup_bump_unit_z_n2792_term) + setup_bump_unit_z_n2788_s19(0);
    setup_bump_unit_z_n2793 <= setup_bump_unit_z_n2792(23 downto 0);
    setup_bump_unit_z_n2794 <= unsigned(setup_bump_unit_z_n2793(23 downto 23));
    setup_bump_unit_z_n2795 <= setup_bump_unit_z_n2794 xor setup_light_length_n42;
    setup_bump_unit_z_n2796 <= unsigned(setup_bump_unit_z_n2793);
    setup_bump_unit_z_n2797 <= setup_bump_unit_z_n2796 & setup_light_length_n43;
    setup_bump_unit_z_n2798 <= signed(setup_bump_unit_z_n2797);
    setup_bump_unit_z_n2799_term <= resize(setup_bump_unit_x_n2216_s19, 26) xor (25 downto 0 => setup_bump_unit_z_n2795(0));
    setup_bump_unit_z_n2799 <= resize(setup_bump_unit_z_n2798, 26) + signed(setup_bump_unit_z_n2799_term) + setup_bump_unit_z_n2795(0);
    setup_bump_unit_z_n2800 <= setup_bump_unit_z_n2799(23 downto 0);
    setup_bump_unit_z_n2801 <= unsigned(setup_bump_unit_z_n2800(23 downto 23));
    setup_bump_unit_z_n2802 <= setup_bump_unit_z_n2801 xor setup_light_length_n42;
    setup_bump_unit_z_n2803 <= resize(setup_bump_unit_z_n2800, 25) + signed(resize(setup_bump_unit_x_n2216_s19, 25));
    setup_bump_unit_z_n2823 <= setup_bump_unit_z_n2822_s19 & setup_bump_unit_z_n2795;
    setup_bump_unit_z_n2824 <= setup_bump_unit_z_n2823 & setup_bump_unit_z_n2802;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_unit_x_n344_s20 <= setup_light_unit_x_n344_s19;
                setup_light_unit_x_n457_s20 <= setup_light_unit_x_n457;
                setup_light_unit_x_n460_s20 <= setup_light_unit_x_n460;
                setup_light_unit_x_n539_s20 <= setup_light_unit_x_n539;
                setup_light_unit_x_n553_s20 <= setup_light_unit_x_n553_s19;
                setup_light_unit_x_n555_s20 <= setup_light_unit_x_n555_s19;
                setup_light_unit_x_n557_s20 <= setup_light_unit_x_n557_s19;
                setup_light_unit_y_n672_s20 <= setup_light_unit_y_n672;
                setup_light_unit_y_n675_s20 <= setup_light_unit_y_n675;
                setup_light_unit_y_n754_s20 <= setup_light_unit_y_n754;
                setup_light_unit_y_n767_s20 <= setup_light_unit_y_n767_s19;
                setup_light_unit_y_n769_s20 <= setup_light_unit_y_n769_s19;
                setup_light_unit_y_n771_s20 <= setup_light_unit_y_n771_s19;
                setup_light_unit_z_n886_s20 <= setup_light_unit_z_n886;
                setup_light_unit_z_n889_s20 <= setup_light_unit_z_n889;
                setup_light_unit_z_n968_s20 <= setup_light_unit_z_n968;
                setup_light_unit_z_n981_s20 <= setup_light_unit_z_n981_s19;
                setup_light_unit_z_n983_s20 <= setup_light_unit_z_n983_s19;
                setup_light_unit_z_n985_s20 <= setup_light_unit_z_n985_s19;
                setup_half_unit_x_n1311_s20 <= setup_half_unit_x_n1311_s19;
                setup_half_unit_x_n1422_s20 <= setup_half_unit_x_n1422;
                setup_half_unit_x_n1425_s20 <= setup_half_unit_x_n1425;
                setup_half_unit_x_n1504_s20 <= setup_half_unit_x_n1504;
                setup_half_unit_x_n1518_s20 <= setup_half_unit_x_n1518_s19;
                setup_half_unit_x_n1520_s20 <= setup_half_unit_x_n1520_s19;
                setup_half_unit_x_n1522_s20 <= setup_half_unit_x_n1522_s19;
                setup_half_unit_y_n1637_s20 <= setup_half_unit_y_n1637;
                setup_half_unit_y_n1640_s20 <= setup_half_unit_y_n1640;
                setup_half_unit_y_n1719_s20 <= setup_half_unit_y_n1719;
                setup_half_unit_y_n1732_s20 <= setup_half_unit_y_n1732_s19;
                setup_half_unit_y_n1734_s20 <= setup_half_unit_y_n1734_s19;
                setup_half_unit_y_n1736_s20 <= setup_half_unit_y_n1736_s19;
                setup_half_unit_z_n1851_s20 <= setup_half_unit_z_n1851;
                setup_half_unit_z_n1854_s20 <= setup_half_unit_z_n1854;
                setup_half_unit_z_n1933_s20 <= setup_half_unit_z_n1933;
                setup_half_unit_z_n1946_s20 <= setup_half_unit_z_n1946_s19;
                setup_half_unit_z_n1948_s20 <= setup_half_unit_z_n1948_s19;
                setup_half_unit_z_n1950_s20 <= setup_half_unit_z_n1950_s19;
                setup_bump_unit_x_n2387_s20 <= setup_bump_unit_x_n2387;
                setup_bump_unit_x_n2388_s20 <= setup_bump_unit_x_n2388;
                setup_bump_unit_x_n2390_s20 <= setup_bump_unit_x_n2390;
                setup_bump_unit_x_n2411_s20 <= setup_bump_unit_x_n2411;
                setup_bump_unit_x_n2415_s20 <= setup_bump_unit_x_n2415_s19;
                setup_bump_unit_x_n2417_s20 <= setup_bump_unit_x_n2417_s19;
                setup_bump_unit_x_n2419_s20 <= setup_bump_unit_x_n2419_s19;
                setup_bump_unit_y_n2594_s20 <= setup_bump_unit_y_n2594;
                setup_bump_unit_y_n2595_s20 <= setup_bump_unit_y_n2595;
                setup_bump_unit_y_n2597_s20 <= setup_bump_unit_y_n2597;
                setup_bump_unit_y_n2618_s20 <= setup_bump_unit_y_n2618;
                setup_bump_unit_y_n2621_s20 <= setup_bump_unit_y_n2621_s19;
                setup_bump_unit_y_n2623_s20 <= setup_bump_unit_y_n2623_s19;
                setup_bump_unit_y_n2625_s20 <= setup_bump_unit_y_n2625_s19;
                setup_bump_unit_z_n2800_s20 <= setup_bump_unit_z_n2800;
                setup_bump_unit_z_n2801_s20 <= setup_bump_unit_z_n2801;
                setup_bump_unit_z_n2803_s20 <= setup_bump_unit_z_n2803;
                setup_bump_unit_z_n2824_s20 <= setup_bump_unit_z_n2824;
                setup_bump_unit_z_n2827_s20 <= setup_bump_unit_z_n2827_s19;
                setup_bump_unit_z_n2829_s20 <= setup_bump_unit_z_n2829_s19;
                setup_bump_unit_z_n2831_s20 <= setup_bump_unit_z_n2831_s19;
            end if;
            if rst = '1' then
                valid_s20 <= '0';
            elsif ce = '1' then
                valid_s20 <= valid_s19;
            end if;
        end if;
    end process;

    -- ---- stage 20 ----
    -- setup.light.unit_x
    setup_light_unit_x_n461_term <= resize(setup_light_unit_x_n344_s20, 26) xor (25 downto 0 => setup_light_unit_x_n457_s20(0));
    setup_light_unit_x_n461 <= resize(setup_light_unit_x_n460_s20, 26) + signed(setup_light_unit_x_n461_term) + setup_light_unit_x_n457_s20(0);
    setup_light_unit_x_n462 <= setup_light_unit_x_n461(23 downto 0);
    setup_light_unit_x_n463 <= unsigned(setup_light_unit_x_n462(23 downto 23));
    setup_light_unit_x_n464 <= setup_light_unit_x_n463 xor setup_light_length_n42;
    setup_light_unit_x_n465 <= unsigned(setup_light_unit_x_n462);
    setup_light_unit_x_n466 <= setup_light_unit_x_n465 & setup_light_length_n43;
    setup_light_unit_x_n467 <= signed(setup_light_unit_x_n466);
    setup_light_unit_x_n468_term <= resize(setup_light_unit_x_n344_s20, 26) xor (25 downto 0 => setup_light_unit_x_n464(0));
    setup_light_unit_x_n468 <= resize(setup_light_unit_x_n467, 26) + signed(setup_light_unit_x_n468_term) + setup_light_unit_x_n464(0);
    setup_light_unit_x_n469 <= setup_light_unit_x_n468(23 downto 0);
    setup_light_unit_x_n470 <= unsigned(setup_light_unit_x_n469(23 downto 23));
    setup_light_unit_x_n471 <= setup_light_unit_x_n470 xor setup_light_length_n42;
    setup_light_unit_x_n472 <= unsigned(setup_light_unit_x_n469);
    setup_light_unit_x_n473 <= setup_light_unit_x_n472 & setup_light_length_n43;
    setup_light_unit_x_n474 <= signed(setup_light_unit_x_n473);
    setup_light_unit_x_n540 <= setup_light_unit_x_n539_s20 & setup_light_unit_x_n464;
    setup_light_unit_x_n541 <= setup_light_unit_x_n540 & setup_light_unit_x_n471;
    -- setup.light.unit_y
    setup_light_unit_y_n676_term <= resize(setup_light_unit_x_n344_s20, 26) xor (25 downto 0 => setup_light_unit_y_n672_s20(0));
    setup_light_unit_y_n676 <= resize(setup_light_unit_y_n675_s20, 26) + signed(setup_light_unit_y_n676_term) + setup_light_unit_y_n672_s20(0);
    setup_light_unit_y_n677 <= setup_light_unit_y_n676(23 downto 0);
    setup_light_unit_y_n678 <= unsigned(setup_light_unit_y_n677(23 downto 23));
    setup_light_unit_y_n679 <= setup_light_unit_y_n678 xor setup_light_length_n42;
    setup_light_unit_y_n680 <= unsigned(setup_light_unit_y_n677);
    setup_light_unit_y_n681 <= setup_light_unit_y_n680 & setup_light_length_n43;
    setup_light_unit_y_n682 <= signed(setup_light_unit_y_n681);
    setup_light_unit_y_n683_term <= resize(setup_light_unit_x_n344_s20, 26) xor (25 downto 0 => setup_light_unit_y_n679(0));
    setup_light_unit_y_n683 <= resize(setup_light_unit_y_n682, 26) + signed(setup_light_unit_y_n683_term) + setup_light_unit_y_n679(0);
    setup_light_unit_y_n684 <= setup_light_unit_y_n683(23 downto 0);
    setup_light_unit_y_n685 <= unsigned(setup_light_unit_y_n684(23 downto 23));
    setup_light_unit_y_n686 <= setup_light_unit_y_n685 xor setup_light_length_n42;
    setup_light_unit_y_n687 <= unsigned(setup_light_unit_y_n684);
    setup_light_unit_y_n688 <= setup_light_unit_y_n687 & setup_light_length_n43;
    setup_light_unit_y_n689 <= signed(setup_light_unit_y_n688);
    setup_light_unit_y_n755 <= setup_light_unit_y_n754_s20 & setup_light_unit_y_n679;
    setup_light_unit_y_n756 <= setup_light_unit_y_n755 & setup_light_unit_y_n686;
    -- setup.light.unit_z
    setup_light_unit_z_n890_term <= resize(setup_light_unit_x_n344_s20, 26) xor (25 downto 0 => setup_light_unit_z_n886_s20(0));
    setup_light_unit_z_n890 <= resize(setup_light_unit_z_n889_s20, 26) + signed(setup_light_unit_z_n890_term) + setup_light_unit_z_n886_s20(0);
    setup_light_unit_z_n891 <= setup_light_unit_z_n890(23 downto 0);
    setup_light_unit_z_n892 <= unsigned(setup_light_unit_z_n891(23 downto 23));
    setup_light_unit_z_n893 <= setup_light_unit_z_n892 xor setup_light_length_n42;
    setup_light_unit_z_n894 <= unsigned(setup_light_unit_z_n891);
    setup_light_unit_z_n895 <= setup_light_unit_z_n894 & setup_light_length_n43;
    setup_light_unit_z_n896 <= signed(setup_light_unit_z_n895);
    setup_light_unit_z_n897_term <= resize(setup_light_unit_x_n344_s20, 26) xor (25 downto 0 => setup_light_unit_z_n893(0));
    setup_light_unit_z_n897 <= resize(setup_light_unit_z_n896, 26) + signed(setup_light_unit_z_n897_term) + setup_light_unit_z_n893(0);
    setup_light_unit_z_n898 <= setup_light_unit_z_n897(23 downto 0);
    setup_light_unit_z_n899 <= unsigned(setup_light_unit_z_n898(23 downto 23));
    setup_light_unit_z_n900 <= setup_light_unit_z_n899 xor setup_light_length_n42;
    setup_light_unit_z_n901 <= unsigned(setup_light_unit_z_n898);
    setup_light_unit_z_n902 <= setup_light_unit_z_n901 & setup_light_length_n43;
    setup_light_unit_z_n903 <= signed(setup_light_unit_z_n902);
    setup_light_unit_z_n969 <= setup_light_unit_z_n968_s20 & setup_light_unit_z_n893;
    setup_light_unit_z_n970 <= setup_light_unit_z_n969 & setup_light_unit_z_n900;
    -- setup.half.unit_x
    setup_half_unit_x_n1426_term <= resize(setup_half_unit_x_n1311_s20, 26) xor (25 downto 0 => setup_half_unit_x_n1422_s20(0));
    setup_half_unit_x_n1426 <= resize(setup_half_unit_x_n1425_s20, 26) + signed(setup_half_unit_x_n1426_term) + setup_half_unit_x_n1422_s20(0);
    setup_half_unit_x_n1427 <= setup_half_unit_x_n1426(23 downto 0);
    setup_half_unit_x_n1428 <= unsigned(setup_half_unit_x_n1427(23 downto 23));
    setup_half_unit_x_n1429 <= setup_half_unit_x_n1428 xor setup_light_length_n42;
    setup_half_unit_x_n1430 <= unsigned(setup_half_unit_x_n1427);
    setup_half_unit_x_n1431 <= setup_half_unit_x_n1430 & setup_light_length_n43;
    setup_half_unit_x_n1432 <= signed(setup_half_unit_x_n1431);
    setup_half_unit_x_n1433_term <= resize(setup_half_unit_x_n1311_s20, 26) xor (25 downto 0 => setup_half_unit_x_n1429(0));
    setup_half_unit_x_n1433 <= resize(setup_half_unit_x_n1432, 26) + signed(setup_half_unit_x_n1433_term) + setup_half_unit_x_n1429(0);
    setup_half_unit_x_n1434 <= setup_half_unit_x_n1433(23 downto 0);
    setup_half_unit_x_n1435 <= unsigned(setup_half_unit_x_n1434(23 downto 23));
    setup_half_unit_x_n1436 <= setup_half_unit_x_n1435 xor setup_light_length_n42;
    setup_half_unit_x_n1437 <= unsigned(setup_half_unit_x_n1434);
    setup_half_unit_x_n1438 <= setup_half_unit_x_n1437 & setup_light_length_n43;
    setup_half_unit_x_n1439 <= signed(setup_half_unit_x_n1438);
    setup_half_unit_x_n1505 <= setup_half_unit_x_n1504_s20 & setup_half_unit_x_n1429;
    setup_half_unit_x_n1506 <= setup_half_unit_x_n1505 & setup_half_unit_x_n1436;
    -- setup.half.unit_y
    setup_half_unit_y_n1641_term <= resize(setup_half_unit_x_n1311_s20, 26) xor (25 downto 0 => setup_half_unit_y_n1637_s20(0));
    setup_half_unit_y_n1641 <= resize(setup_half_unit_y_n1640_s20, 26) + signed(setup_half_unit_y_n1641_term) + setup_half_unit_y_n1637_s20(0);
    setup_half_unit_y_n1642 <= setup_half_unit_y_n1641(23 downto 0);
    setup_half_unit_y_n1643 <= unsigned(setup_half_unit_y_n1642(23 downto 23));
    setup_half_unit_y_n1644 <= setup_half_unit_y_n1643 xor setup_light_length_n42;
    setup_half_unit_y_n1645 <= unsigned(setup_half_unit_y_n1642);
    setup_half_unit_y_n1646 <= setup_half_unit_y_n1645 & setup_light_length_n43;
    setup_half_unit_y_n1647 <= signed(setup_half_unit_y_n1646);
    setup_half_unit_y_n1648_term <= resize(setup_half_unit_x_n1311_s20, 26) xor (25 downto 0 => setup_half_unit_y_n1644(0));
    setup_half_unit_y_n1648 <= resize(setup_half_unit_y_n1647, 26) + signed(setup_half_unit_y_n1648_term) + setup_half_unit_y_n1644(0);
    setup_half_unit_y_n1649 <= setup_half_unit_y_n1648(23 downto 0);
    setup_half_unit_y_n1650 <= unsigned(setup_half_unit_y_n1649(23 downto 23));
    setup_half_unit_y_n1651 <= setup_half_unit_y_n1650 xor setup_light_length_n42;
    setup_half_unit_y_n1652 <= unsigned(setup_half_unit_y_n1649);
    setup_half_unit_y_n1653 <= setup_half_unit_y_n1652 & setup_light_length_n43;
    setup_half_unit_y_n1654 <= signed(setup_half_unit_y_n1653);
    setup_half_unit_y_n1720 <= setup_half_unit_y_n1719_s20 & setup_half_unit_y_n1644;
    setup_half_unit_y_n1721 <= setup_half_unit_y_n1720 & setup_half_unit_y_n1651;
    -- setup.half.unit_z
    setup_half_unit_z_n1855_term <= resize(setup_half_unit_x_n1311_s20, 26) xor (25 downto 0 => setup_half_unit_z_n1851_s20(0));
    setup_half_unit_z_n1855 <= resize(setup_half_unit_z_n1854_s20, 26) + signed(setup_half_unit_z_n1855_term) + setup_half_unit_z_n1851_s20(0);
    setup_half_unit_z_n1856 <= setup_half_unit_z_n1855(23 downto 0);
    setup_half_unit_z_n1857 <= unsigned(setup_half_unit_z_n1856(23 downto 23));
    setup_half_unit_z_n1858 <= setup_half_unit_z_n1857 xor setup_light_length_n42;
    setup_half_unit_z_n1859 <= unsigned(setup_half_unit_z_n1856);
    setup_half_unit_z_n1860 <= setup_half_unit_z_n1859 & setup_light_length_n43;
    setup_half_unit_z_n1861 <= signed(setup_half_unit_z_n1860);
    setup_half_unit_z_n1862_term <= resize(setup_half_unit_x_n1311_s20, 26) xor (25 downto 0 => setup_half_unit_z_n1858(0));
    setup_half_unit_z_n1862 <= resize(setup_half_unit_z_n1861, 26) + signed(setup_half_unit_z_n1862_term) + setup_half_unit_z_n1858(0);
    setup_half_unit_z_n1863 <= setup_half_unit_z_n1862(23 downto 0);
    setup_half_unit_z_n1864 <= unsigned(setup_half_unit_z_n1863(23 downto 23));
    setup_half_unit_z_n1865 <= setup_half_unit_z_n1864 xor setup_light_length_n42;
    setup_half_unit_z_n1866 <= unsigned(setup_half_unit_z_n1863);
    setup_half_unit_z_n1867 <= setup_half_unit_z_n1866 & setup_light_length_n43;
    setup_half_unit_z_n1868 <= signed(setup_half_unit_z_n1867);
    setup_half_unit_z_n1934 <= setup_half_unit_z_n1933_s20 & setup_half_unit_z_n1858;
    setup_half_unit_z_n1935 <= setup_half_unit_z_n1934 & setup_half_unit_z_n1865;
    -- setup.bump.unit_x
    setup_bump_unit_x_n2391 <= setup_bump_unit_x_n2390_s20 when setup_bump_unit_x_n2388_s20(0) = '1' else resize(setup_bump_unit_x_n2387_s20, 25);
    setup_bump_unit_x_n2392 <= "1" when unsigned(setup_bump_unit_x_n2391) = resize(setup_light_length_n43, 25) else "0";
    setup_bump_unit_x_n2393 <= setup_bump_unit_x_n2392 xor setup_light_length_n42;
    setup_bump_unit_x_n2412 <= setup_bump_unit_x_n2411_s20 & setup_bump_unit_x_n2393;
    setup_bump_unit_x_n2413 <= setup_bump_unit_x_n2412;
    setup_bump_unit_x_n2416 <= shift_left(resize(setup_light_unit_x_n343, 20), 19) when setup_bump_unit_x_n2415_s20(0) = '1' else setup_bump_unit_x_n2413;
    setup_bump_unit_x_n2418 <= shift_left(resize(setup_light_length_n43, 20), 18) when setup_bump_unit_x_n2417_s20(0) = '1' else setup_bump_unit_x_n2416;
    setup_bump_unit_x_n2420 <= -signed(resize(setup_bump_unit_x_n2418, 21));
    -- setup.bump.unit_y
    setup_bump_unit_y_n2598 <= setup_bump_unit_y_n2597_s20 when setup_bump_unit_y_n2595_s20(0) = '1' else resize(setup_bump_unit_y_n2594_s20, 25);
    setup_bump_unit_y_n2599 <= "1" when unsigned(setup_bump_unit_y_n2598) = resize(setup_light_length_n43, 25) else "0";
    setup_bump_unit_y_n2600 <= setup_bump_unit_y_n2599 xor setup_light_length_n42;
    setup_bump_unit_y_n2619 <= setup_bump_unit_y_n2618_s20 & setup_bump_unit_y_n2600;
    setup_bump_unit_y_n2620 <= setup_bump_unit_y_n2619;
    setup_bump_unit_y_n2622 <= shift_left(resize(setup_light_unit_x_n343, 20), 19) when setup_bump_unit_y_n2621_s20(0) = '1' else setup_bump_unit_y_n2620;
    setup_bump_unit_y_n2624 <= shift_left(resize(setup_light_length_n43, 20), 18) when setup_bump_unit_y_n2623_s20(0) = '1' else setup_bump_unit_y_n2622;
    setup_bump_unit_y_n2626 <= -signed(resize(setup_bump_unit_y_n2624, 21));
    -- setup.bump.unit_z
    setup_bump_unit_z_n2804 <= setup_bump_unit_z_n2803_s20 when setup_bump_unit_z_n2801_s20(0) = '1' else resize(setup_bump_unit_z_n2800_s20, 25);
    setup_bump_unit_z_n2805 <= "1" when unsigned(setup_bump_unit_z_n2804) = resize(setup_light_length_n43, 25) else "0";
    setup_bump_unit_z_n2806 <= setup_bump_unit_z_n2805 xor setup_light_length_n42;
    setup_bump_unit_z_n2825 <= setup_bump_unit_z_n2824_s20 & setup_bump_unit_z_n2806;
    setup_bump_unit_z_n2826 <= setup_bump_unit_z_n2825;
    setup_bump_unit_z_n2828 <= shift_left(resize(setup_light_unit_x_n343, 20), 19) when setup_bump_unit_z_n2827_s20(0) = '1' else setup_bump_unit_z_n2826;
    setup_bump_unit_z_n2830 <= shift_left(resize(setup_light_length_n43, 20), 18) when setup_bump_unit_z_n2829_s20(0) = '1' else setup_bump_unit_z_n2828;
    setup_bump_unit_z_n2832 <= -signed(resize(setup_bump_unit_z_n2830, 21));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_unit_x_n344_s21 <= setup_light_unit_x_n344_s20;
                setup_light_unit_x_n471_s21 <= setup_light_unit_x_n471;
                setup_light_unit_x_n474_s21 <= setup_light_unit_x_n474;
                setup_light_unit_x_n541_s21 <= setup_light_unit_x_n541;
                setup_light_unit_x_n553_s21 <= setup_light_unit_x_n553_s20;
                setup_light_unit_x_n555_s21 <= setup_light_unit_x_n555_s20;
                setup_light_unit_x_n557_s21 <= setup_light_unit_x_n557_s20;
                setup_light_unit_y_n686_s21 <= setup_light_unit_y_n686;
                setup_light_unit_y_n689_s21 <= setup_light_unit_y_n689;
                setup_light_unit_y_n756_s21 <= setup_light_unit_y_n756;
                setup_light_unit_y_n767_s21 <= setup_light_unit_y_n767_s20;
                setup_light_unit_y_n769_s21 <= setup_light_unit_y_n769_s20;
                setup_light_unit_y_n771_s21 <= setup_light_unit_y_n771_s20;
                setup_light_unit_z_n900_s21 <= setup_light_unit_z_n900;
                setup_light_unit_z_n903_s21 <= setup_light_unit_z_n903;
                setup_light_unit_z_n970_s21 <= setup_light_unit_z_n970;
                setup_light_unit_z_n981_s21 <= setup_light_unit_z_n981_s20;
                setup_light_unit_z_n983_s21 <= setup_light_unit_z_n983_s20;
                setup_light_unit_z_n985_s21 <= setup_light_unit_z_n985_s20;
                setup_half_unit_x_n1311_s21 <= setup_half_unit_x_n1311_s20;
                setup_half_unit_x_n1436_s21 <= setup_half_unit_x_n1436;
                setup_half_unit_x_n1439_s21 <= setup_half_unit_x_n1439;
                setup_half_unit_x_n1506_s21 <= setup_half_unit_x_n1506;
                setup_half_unit_x_n1518_s21 <= setup_half_unit_x_n1518_s20;
                setup_half_unit_x_n1520_s21 <= setup_half_unit_x_n1520_s20;
                setup_half_unit_x_n1522_s21 <= setup_half_unit_x_n1522_s20;
                setup_half_unit_y_n1651_s21 <= setup_half_unit_y_n1651;
                setup_half_unit_y_n1654_s21 <= setup_half_unit_y_n1654;
                setup_half_unit_y_n1721_s21 <= setup_half_unit_y_n1721;
                setup_half_unit_y_n1732_s21 <= setup_half_unit_y_n1732_s20;
                setup_half_unit_y_n1734_s21 <= setup_half_unit_y_n1734_s20;
                setup_half_unit_y_n1736_s21 <= setup_half_unit_y_n1736_s20;
                setup_half_unit_z_n1865_s21 <= setup_half_unit_z_n1865;
                setup_half_unit_z_n1868_s21 <= setup_half_unit_z_n1868;
                setup_half_unit_z_n1935_s21 <= setup_half_unit_z_n1935;
                setup_half_unit_z_n1946_s21 <= setup_half_unit_z_n1946_s20;
                setup_half_unit_z_n1948_s21 <= setup_half_unit_z_n1948_s20;
                setup_half_unit_z_n1950_s21 <= setup_half_unit_z_n1950_s20;
                setup_bump_unit_x_n2418_s21 <= setup_bump_unit_x_n2418;
                setup_bump_unit_x_n2419_s21 <= setup_bump_unit_x_n2419_s20;
                setup_bump_unit_x_n2420_s21 <= setup_bump_unit_x_n2420;
                setup_bump_unit_y_n2624_s21 <= setup_bump_unit_y_n2624;
                setup_bump_unit_y_n2625_s21 <= setup_bump_unit_y_n2625_s20;
                setup_bump_unit_y_n2626_s21 <= setup_bump_unit_y_n2626;
                setup_bump_unit_z_n2830_s21 <= setup_bump_unit_z_n2830;
                setup_bump_unit_z_n2831_s21 <= setup_bump_unit_z_n2831_s20;
                setup_bump_unit_z_n2832_s21 <= setup_bump_unit_z_n2832;
            end if;
            if rst = '1' then
                valid_s21 <= '0';
            elsif ce = '1' then
                valid_s21 <= valid_s20;
            end if;
        end if;
    end process;

    -- ---- stage 21 ----
    -- setup.light.unit_x
    setup_light_unit_x_n475_term <= resize(setup_light_unit_x_n344_s21, 26) xor (25 downto 0 => setup_light_unit_x_n471_s21(0));
    setup_light_unit_x_n475 <= resize(setup_light_unit_x_n474_s21, 26) + signed(setup_light_unit_x_n475_term) + setup_light_unit_x_n471_s21(0);
    setup_light_unit_x_n476 <= setup_light_unit_x_n475(23 downto 0);
    setup_light_unit_x_n477 <= unsigned(setup_light_unit_x_n476(23 downto 23));
    setup_light_unit_x_n478 <= setup_light_unit_x_n477 xor setup_light_length_n42;
    setup_light_unit_x_n479 <= unsigned(setup_light_unit_x_n476);
    setup_light_unit_x_n480 <= setup_light_unit_x_n479 & setup_light_length_n43;
    setup_light_unit_x_n481 <= signed(setup_light_unit_x_n480);
    setup_light_unit_x_n482_term <= resize(setup_light_unit_x_n344_s21, 26) xor (25 downto 0 => setup_light_unit_x_n478(0));
    setup_light_unit_x_n482 <= resize(setup_light_unit_x_n481, 26) + signed(setup_light_unit_x_n482_term) + setup_light_unit_x_n478(0);
    setup_light_unit_x_n483 <= setup_light_unit_x_n482(23 downto 0);
    setup_light_unit_x_n484 <= unsigned(setup_light_unit_x_n483(23 downto 23));
    setup_light_unit_x_n485 <= setup_light_unit_x_n484 xor setup_light_length_n42;
    setup_light_unit_x_n486 <= unsigned(setup_light_unit_x_n483);
    setup_light_unit_x_n487 <= setup_light_unit_x_n486 & setup_light_length_n43;
    setup_light_unit_x_n488 <= signed(setup_light_unit_x_n487);
    setup_light_unit_x_n542 <= setup_light_unit_x_n541_s21 & setup_light_unit_x_n478;
    setup_light_unit_x_n543 <= setup_light_unit_x_n542 & setup_light_unit_x_n485;
    -- setup.light.unit_y
    setup_light_unit_y_n690_term <= resize(setup_light_unit_x_n344_s21, 26) xor (25 downto 0 => setup_light_unit_y_n686_s21(0));
    setup_light_unit_y_n690 <= resize(setup_light_unit_y_n689_s21, 26) + signed(setup_light_unit_y_n690_term) + setup_light_unit_y_n686_s21(0);
    setup_light_unit_y_n691 <= setup_light_unit_y_n690(23 downto 0);
    setup_light_unit_y_n692 <= unsigned(setup_light_unit_y_n691(23 downto 23));
    setup_light_unit_y_n693 <= setup_light_unit_y_n692 xor setup_light_length_n42;
    setup_light_unit_y_n694 <= unsigned(setup_light_unit_y_n691);
    setup_light_unit_y_n695 <= setup_light_unit_y_n694 & setup_light_length_n43;
    setup_light_unit_y_n696 <= signed(setup_light_unit_y_n695);
    setup_light_unit_y_n697_term <= resize(setup_light_unit_x_n344_s21, 26) xor (25 downto 0 => setup_light_unit_y_n693(0));
    setup_light_unit_y_n697 <= resize(setup_light_unit_y_n696, 26) + signed(setup_light_unit_y_n697_term) + setup_light_unit_y_n693(0);
    setup_light_unit_y_n698 <= setup_light_unit_y_n697(23 downto 0);
    setup_light_unit_y_n699 <= unsigned(setup_light_unit_y_n698(23 downto 23));
    setup_light_unit_y_n700 <= setup_light_unit_y_n699 xor setup_light_length_n42;
    setup_light_unit_y_n701 <= unsigned(setup_light_unit_y_n698);
    setup_light_unit_y_n702 <= setup_light_unit_y_n701 & setup_light_length_n43;
    setup_light_unit_y_n703 <= signed(setup_light_unit_y_n702);
    setup_light_unit_y_n757 <= setup_light_unit_y_n756_s21 & setup_light_unit_y_n693;
    setup_light_unit_y_n758 <= setup_light_unit_y_n757 & setup_light_unit_y_n700;
    -- setup.light.unit_z
    setup_light_unit_z_n904_term <= resize(setup_light_unit_x_n344_s21, 26) xor (25 downto 0 => setup_light_unit_z_n900_s21(0));
    setup_light_unit_z_n904 <= resize(setup_light_unit_z_n903_s21, 26) + signed(setup_light_unit_z_n904_term) + setup_light_unit_z_n900_s21(0);
    setup_light_unit_z_n905 <= setup_light_unit_z_n904(23 downto 0);
    setup_light_unit_z_n906 <= unsigned(setup_light_unit_z_n905(23 downto 23));
    setup_light_unit_z_n907 <= setup_light_unit_z_n906 xor setup_light_length_n42;
    setup_light_unit_z_n908 <= unsigned(setup_light_unit_z_n905);
    setup_light_unit_z_n909 <= setup_light_unit_z_n908 & setup_light_length_n43;
    setup_light_unit_z_n910 <= signed(setup_light_unit_z_n909);
    setup_light_unit_z_n911_term <= resize(setup_light_unit_x_n344_s21, 26) xor (25 downto 0 => setup_light_unit_z_n907(0));
    setup_light_unit_z_n911 <= resize(setup_light_unit_z_n910, 26) + signed(setup_light_unit_z_n911_term) + setup_light_unit_z_n907(0);
    setup_light_unit_z_n912 <= setup_light_unit_z_n911(23 downto 0);
    setup_light_unit_z_n913 <= unsigned(setup_light_unit_z_n912(23 downto 23));
    setup_light_unit_z_n914 <= setup_light_unit_z_n913 xor setup_light_length_n42;
    setup_light_unit_z_n915 <= unsigned(setup_light_unit_z_n912);
    setup_light_unit_z_n916 <= setup_light_unit_z_n915 & setup_light_length_n43;
    setup_light_unit_z_n917 <= signed(setup_light_unit_z_n916);
    setup_light_unit_z_n971 <= setup_light_unit_z_n970_s21 & setup_light_unit_z_n907;
    setup_light_unit_z_n972 <= setup_light_unit_z_n971 & setup_light_unit_z_n914;
    -- setup.half.unit_x
    setup_half_unit_x_n1440_term <= resize(setup_half_unit_x_n1311_s21, 26) xor (25 downto 0 => setup_half_unit_x_n1436_s21(0));
    setup_half_unit_x_n1440 <= resize(setup_half_unit_x_n1439_s21, 26) + signed(setup_half_unit_x_n1440_term) + setup_half_unit_x_n1436_s21(0);
    setup_half_unit_x_n1441 <= setup_half_unit_x_n1440(23 downto 0);
    setup_half_unit_x_n1442 <= unsigned(setup_half_unit_x_n1441(23 downto 23));
    setup_half_unit_x_n1443 <= setup_half_unit_x_n1442 xor setup_light_length_n42;
    setup_half_unit_x_n1444 <= unsigned(setup_half_unit_x_n1441);
    setup_half_unit_x_n1445 <= setup_half_unit_x_n1444 & setup_light_length_n43;
    setup_half_unit_x_n1446 <= signed(setup_half_unit_x_n1445);
    setup_half_unit_x_n1447_term <= resize(setup_half_unit_x_n1311_s21, 26) xor (25 downto 0 => setup_half_unit_x_n1443(0));
    setup_half_unit_x_n1447 <= resize(setup_half_unit_x_n1446, 26) + signed(setup_half_unit_x_n1447_term) + setup_half_unit_x_n1443(0);
    setup_half_unit_x_n1448 <= setup_half_unit_x_n1447(23 downto 0);
    setup_half_unit_x_n1449 <= unsigned(setup_half_unit_x_n1448(23 downto 23));
    setup_half_unit_x_n1450 <= setup_half_unit_x_n1449 xor setup_light_length_n42;
    setup_half_unit_x_n1451 <= unsigned(setup_half_unit_x_n1448);
    setup_half_unit_x_n1452 <= setup_half_unit_x_n1451 & setup_light_length_n43;
    setup_half_unit_x_n1453 <= signed(setup_half_unit_x_n1452);
    setup_half_unit_x_n1507 <= setup_half_unit_x_n1506_s21 & setup_half_unit_x_n1443;
    setup_half_unit_x_n1508 <= setup_half_unit_x_n1507 & setup_half_unit_x_n1450;
    -- setup.half.unit_y
    setup_half_unit_y_n1655_term <= resize(setup_half_unit_x_n1311_s21, 26) xor (25 downto 0 => setup_half_unit_y_n1651_s21(0));
    setup_half_unit_y_n1655 <= resize(setup_half_unit_y_n1654_s21, 26) + signed(setup_half_unit_y_n1655_term) + setup_half_unit_y_n1651_s21(0);
    setup_half_unit_y_n1656 <= setup_half_unit_y_n1655(23 downto 0);
    setup_half_unit_y_n1657 <= unsigned(setup_half_unit_y_n1656(23 downto 23));
    setup_half_unit_y_n1658 <= setup_half_unit_y_n1657 xor setup_light_length_n42;
    setup_half_unit_y_n1659 <= unsigned(setup_half_unit_y_n1656);
    setup_half_unit_y_n1660 <= setup_half_unit_y_n1659 & setup_light_length_n43;
    setup_half_unit_y_n1661 <= signed(setup_half_unit_y_n1660);
    setup_half_unit_y_n1662_term <= resize(setup_half_unit_x_n1311_s21, 26) xor (25 downto 0 => setup_half_unit_y_n1658(0));
    setup_half_unit_y_n1662 <= resize(setup_half_unit_y_n1661, 26) + signed(setup_half_unit_y_n1662_term) + setup_half_unit_y_n1658(0);
    setup_half_unit_y_n1663 <= setup_half_unit_y_n1662(23 downto 0);
    setup_half_unit_y_n1664 <= unsigned(setup_half_unit_y_n1663(23 downto 23));
    setup_half_unit_y_n1665 <= setup_half_unit_y_n1664 xor setup_light_length_n42;
    setup_half_unit_y_n1666 <= unsigned(setup_half_unit_y_n1663);
    setup_half_unit_y_n1667 <= setup_half_unit_y_n1666 & setup_light_length_n43;
    setup_half_unit_y_n1668 <= signed(setup_half_unit_y_n1667);
    setup_half_unit_y_n1722 <= setup_half_unit_y_n1721_s21 & setup_half_unit_y_n1658;
    setup_half_unit_y_n1723 <= setup_half_unit_y_n1722 & setup_half_unit_y_n1665;
    -- setup.half.unit_z
    setup_half_unit_z_n1869_term <= resize(setup_half_unit_x_n1311_s21, 26) xor (25 downto 0 => setup_half_unit_z_n1865_s21(0));
    setup_half_unit_z_n1869 <= resize(setup_half_unit_z_n1868_s21, 26) + signed(setup_half_unit_z_n1869_term) + setup_half_unit_z_n1865_s21(0);
    setup_half_unit_z_n1870 <= setup_half_unit_z_n1869(23 downto 0);
    setup_half_unit_z_n1871 <= unsigned(setup_half_unit_z_n1870(23 downto 23));
    setup_half_unit_z_n1872 <= setup_half_unit_z_n1871 xor setup_light_length_n42;
    setup_half_unit_z_n1873 <= unsigned(setup_half_unit_z_n1870);
    setup_half_unit_z_n1874 <= setup_half_unit_z_n1873 & setup_light_length_n43;
    setup_half_unit_z_n1875 <= signed(setup_half_unit_z_n1874);
    setup_half_unit_z_n1876_term <= resize(setup_half_unit_x_n1311_s21, 26) xor (25 downto 0 => setup_half_unit_z_n1872(0));
    setup_half_unit_z_n1876 <= resize(setup_half_unit_z_n1875, 26) + signed(setup_half_unit_z_n1876_term) + setup_half_unit_z_n1872(0);
    setup_half_unit_z_n1877 <= setup_half_unit_z_n1876(23 downto 0);
    setup_half_unit_z_n1878 <= unsigned(setup_half_unit_z_n1877(23 downto 23));
    setup_half_unit_z_n1879 <= setup_half_unit_z_n1878 xor setup_light_length_n42;
    setup_half_unit_z_n1880 <= unsigned(setup_half_unit_z_n1877);
    setup_half_unit_z_n1881 <= setup_half_unit_z_n1880 & setup_light_length_n43;
    setup_half_unit_z_n1882 <= signed(setup_half_unit_z_n1881);
    setup_half_unit_z_n1936 <= setup_half_unit_z_n1935_s21 & setup_half_unit_z_n1872;
    setup_half_unit_z_n1937 <= setup_half_unit_z_n1936 & setup_half_unit_z_n1879;
    -- setup.bump.unit_x
    setup_bump_unit_x_n2421 <= setup_bump_unit_x_n2420_s21 when setup_bump_unit_x_n2419_s21(0) = '1' else signed(resize(setup_bump_unit_x_n2418_s21, 21));
    setup_bump_unit_x_x_sum <= resize(setup_bump_unit_x_n2421, 22) + 22x"000002";
    setup_bump_unit_x_x_cut <= setup_bump_unit_x_x_sum(21 downto 2);
    setup_bump_unit_x_x_over <= "1" when setup_bump_unit_x_x_cut(19) = '0' and (or setup_bump_unit_x_x_cut(18 downto 17)) = '1' else "0";
    setup_bump_unit_x_x_under <= "1" when setup_bump_unit_x_x_cut(19) = '1' and (and setup_bump_unit_x_x_cut(18 downto 17)) = '0' else "0";
    setup_bump_unit_x_x <= 18x"1ffff" when setup_bump_unit_x_x_over(0) = '1' else 18x"20000" when setup_bump_unit_x_x_under(0) = '1' else setup_bump_unit_x_x_cut(17 downto 0);
    -- setup.bump.unit_y
    setup_bump_unit_y_n2627 <= setup_bump_unit_y_n2626_s21 when setup_bump_unit_y_n2625_s21(0) = '1' else signed(resize(setup_bump_unit_y_n2624_s21, 21));
    setup_bump_unit_y_y_sum <= resize(setup_bump_unit_y_n2627, 22) + 22x"000002";
    setup_bump_unit_y_y_cut <= setup_bump_unit_y_y_sum(21 downto 2);
    setup_bump_unit_y_y_over <= "1" when setup_bump_unit_y_y_cut(19) = '0' and (or setup_bump_unit_y_y_cut(18 downto 17)) = '1' else "0";
    setup_bump_unit_y_y_under <= "1" when setup_bump_unit_y_y_cut(19) = '1' and (and setup_bump_unit_y_y_cut(18 downto 17)) = '0' else "0";
    setup_bump_unit_y_y <= 18x"1ffff" when setup_bump_unit_y_y_over(0) = '1' else 18x"20000" when setup_bump_unit_y_y_under(0) = '1' else setup_bump_unit_y_y_cut(17 downto 0);
    -- setup.bump.unit_z
    setup_bump_unit_z_n2833 <= setup_bump_unit_z_n2832_s21 when setup_bump_unit_z_n2831_s21(0) = '1' else signed(resize(setup_bump_unit_z_n2830_s21, 21));
    setup_bump_unit_z_z_sum <= resize(setup_bump_unit_z_n2833, 22) + 22x"000002";
    setup_bump_unit_z_z_cut <= setup_bump_unit_z_z_sum(21 downto 2);
    setup_bump_unit_z_z_over <= "1" when setup_bump_unit_z_z_cut(19) = '0' and (or setup_bump_unit_z_z_cut(18 downto 17)) = '1' else "0";
    setup_bump_unit_z_z_under <= "1" when setup_bump_unit_z_z_cut(19) = '1' and (and setup_bump_unit_z_z_cut(18 downto 17)) = '0' else "0";
    setup_bump_unit_z_z <= 18x"1ffff" when setup_bump_unit_z_z_over(0) = '1' else 18x"20000" when setup_bump_unit_z_z_under(0) = '1' else setup_bump_unit_z_z_cut(17 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_unit_x_n344_s22 <= setup_light_unit_x_n344_s21;
                setup_light_unit_x_n485_s22 <= setup_light_unit_x_n485;
                setup_light_unit_x_n488_s22 <= setup_light_unit_x_n488;
                setup_light_unit_x_n543_s22 <= setup_light_unit_x_n543;
                setup_light_unit_x_n553_s22 <= setup_light_unit_x_n553_s21;
                setup_light_unit_x_n555_s22 <= setup_light_unit_x_n555_s21;
                setup_light_unit_x_n557_s22 <= setup_light_unit_x_n557_s21;
                setup_light_unit_y_n700_s22 <= setup_light_unit_y_n700;
                setup_light_unit_y_n703_s22 <= setup_light_unit_y_n703;
                setup_light_unit_y_n758_s22 <= setup_light_unit_y_n758;
                setup_light_unit_y_n767_s22 <= setup_light_unit_y_n767_s21;
                setup_light_unit_y_n769_s22 <= setup_light_unit_y_n769_s21;
                setup_light_unit_y_n771_s22 <= setup_light_unit_y_n771_s21;
                setup_light_unit_z_n914_s22 <= setup_light_unit_z_n914;
                setup_light_unit_z_n917_s22 <= setup_light_unit_z_n917;
                setup_light_unit_z_n972_s22 <= setup_light_unit_z_n972;
                setup_light_unit_z_n981_s22 <= setup_light_unit_z_n981_s21;
                setup_light_unit_z_n983_s22 <= setup_light_unit_z_n983_s21;
                setup_light_unit_z_n985_s22 <= setup_light_unit_z_n985_s21;
                setup_half_unit_x_n1311_s22 <= setup_half_unit_x_n1311_s21;
                setup_half_unit_x_n1450_s22 <= setup_half_unit_x_n1450;
                setup_half_unit_x_n1453_s22 <= setup_half_unit_x_n1453;
                setup_half_unit_x_n1508_s22 <= setup_half_unit_x_n1508;
                setup_half_unit_x_n1518_s22 <= setup_half_unit_x_n1518_s21;
                setup_half_unit_x_n1520_s22 <= setup_half_unit_x_n1520_s21;
                setup_half_unit_x_n1522_s22 <= setup_half_unit_x_n1522_s21;
                setup_half_unit_y_n1665_s22 <= setup_half_unit_y_n1665;
                setup_half_unit_y_n1668_s22 <= setup_half_unit_y_n1668;
                setup_half_unit_y_n1723_s22 <= setup_half_unit_y_n1723;
                setup_half_unit_y_n1732_s22 <= setup_half_unit_y_n1732_s21;
                setup_half_unit_y_n1734_s22 <= setup_half_unit_y_n1734_s21;
                setup_half_unit_y_n1736_s22 <= setup_half_unit_y_n1736_s21;
                setup_half_unit_z_n1879_s22 <= setup_half_unit_z_n1879;
                setup_half_unit_z_n1882_s22 <= setup_half_unit_z_n1882;
                setup_half_unit_z_n1937_s22 <= setup_half_unit_z_n1937;
                setup_half_unit_z_n1946_s22 <= setup_half_unit_z_n1946_s21;
                setup_half_unit_z_n1948_s22 <= setup_half_unit_z_n1948_s21;
                setup_half_unit_z_n1950_s22 <= setup_half_unit_z_n1950_s21;
                setup_bump_unit_x_x_s22 <= setup_bump_unit_x_x;
                setup_bump_unit_y_y_s22 <= setup_bump_unit_y_y;
                setup_bump_unit_z_z_s22 <= setup_bump_unit_z_z;
            end if;
            if rst = '1' then
                valid_s22 <= '0';
            elsif ce = '1' then
                valid_s22 <= valid_s21;
            end if;
        end if;
    end process;

    -- ---- stage 22 ----
    -- setup.light.unit_x
    setup_light_unit_x_n489_term <= resize(setup_light_unit_x_n344_s22, 26) xor (25 downto 0 => setup_light_unit_x_n485_s22(0));
    setup_light_unit_x_n489 <= resize(setup_light_unit_x_n488_s22, 26) + signed(setup_light_unit_x_n489_term) + setup_light_unit_x_n485_s22(0);
    setup_light_unit_x_n490 <= setup_light_unit_x_n489(23 downto 0);
    setup_light_unit_x_n491 <= unsigned(setup_light_unit_x_n490(23 downto 23));
    setup_light_unit_x_n492 <= setup_light_unit_x_n491 xor setup_light_length_n42;
    setup_light_unit_x_n493 <= unsigned(setup_light_unit_x_n490);
    setup_light_unit_x_n494 <= setup_light_unit_x_n493 & setup_light_length_n43;
    setup_light_unit_x_n495 <= signed(setup_light_unit_x_n494);
    setup_light_unit_x_n496_term <= resize(setup_light_unit_x_n344_s22, 26) xor (25 downto 0 => setup_light_unit_x_n492(0));
    setup_light_unit_x_n496 <= resize(setup_light_unit_x_n495, 26) + signed(setup_light_unit_x_n496_term) + setup_light_unit_x_n492(0);
    setup_light_unit_x_n497 <= setup_light_unit_x_n496(23 downto 0);
    setup_light_unit_x_n498 <= unsigned(setup_light_unit_x_n497(23 downto 23));
    setup_light_unit_x_n499 <= setup_light_unit_x_n498 xor setup_light_length_n42;
    setup_light_unit_x_n500 <= unsigned(setup_light_unit_x_n497);
    setup_light_unit_x_n501 <= setup_light_unit_x_n500 & setup_light_length_n43;
    setup_light_unit_x_n502 <= signed(setup_light_unit_x_n501);
    setup_light_unit_x_n544 <= setup_light_unit_x_n543_s22 & setup_light_unit_x_n492;
    setup_light_unit_x_n545 <= setup_light_unit_x_n544 & setup_light_unit_x_n499;
    -- setup.light.unit_y
    setup_light_unit_y_n704_term <= resize(setup_light_unit_x_n344_s22, 26) xor (25 downto 0 => setup_light_unit_y_n700_s22(0));
    setup_light_unit_y_n704 <= resize(setup_light_unit_y_n703_s22, 26) + signed(setup_light_unit_y_n704_term) + setup_light_unit_y_n700_s22(0);
    setup_light_unit_y_n705 <= setup_light_unit_y_n704(23 downto 0);
    setup_light_unit_y_n706 <= unsigned(setup_light_unit_y_n705(23 downto 23));
    setup_light_unit_y_n707 <= setup_light_unit_y_n706 xor setup_light_length_n42;
    setup_light_unit_y_n708 <= unsigned(setup_light_unit_y_n705);
    setup_light_unit_y_n709 <= setup_light_unit_y_n708 & setup_light_length_n43;
    setup_light_unit_y_n710 <= signed(setup_light_unit_y_n709);
    setup_light_unit_y_n711_term <= resize(setup_light_unit_x_n344_s22, 26) xor (25 downto 0 => setup_light_unit_y_n707(0));
    setup_light_unit_y_n711 <= resize(setup_light_unit_y_n710, 26) + signed(setup_light_unit_y_n711_term) + setup_light_unit_y_n707(0);
    setup_light_unit_y_n712 <= setup_light_unit_y_n711(23 downto 0);
    setup_light_unit_y_n713 <= unsigned(setup_light_unit_y_n712(23 downto 23));
    setup_light_unit_y_n714 <= setup_light_unit_y_n713 xor setup_light_length_n42;
    setup_light_unit_y_n715 <= unsigned(setup_light_unit_y_n712);
    setup_light_unit_y_n716 <= setup_light_unit_y_n715 & setup_light_length_n43;
    setup_light_unit_y_n717 <= signed(setup_light_unit_y_n716);
    setup_light_unit_y_n759 <= setup_light_unit_y_n758_s22 & setup_light_unit_y_n707;
    setup_light_unit_y_n760 <= setup_light_unit_y_n759 & setup_light_unit_y_n714;
    -- setup.light.unit_z
    setup_light_unit_z_n918_term <= resize(setup_light_unit_x_n344_s22, 26) xor (25 downto 0 => setup_light_unit_z_n914_s22(0));
    setup_light_unit_z_n918 <= resize(setup_light_unit_z_n917_s22, 26) + signed(setup_light_unit_z_n918_term) + setup_light_unit_z_n914_s22(0);
    setup_light_unit_z_n919 <= setup_light_unit_z_n918(23 downto 0);
    setup_light_unit_z_n920 <= unsigned(setup_light_unit_z_n919(23 downto 23));
    setup_light_unit_z_n921 <= setup_light_unit_z_n920 xor setup_light_length_n42;
    setup_light_unit_z_n922 <= unsigned(setup_light_unit_z_n919);
    setup_light_unit_z_n923 <= setup_light_unit_z_n922 & setup_light_length_n43;
    setup_light_unit_z_n924 <= signed(setup_light_unit_z_n923);
    setup_light_unit_z_n925_term <= resize(setup_light_unit_x_n344_s22, 26) xor (25 downto 0 => setup_light_unit_z_n921(0));
    setup_light_unit_z_n925 <= resize(setup_light_unit_z_n924, 26) + signed(setup_light_unit_z_n925_term) + setup_light_unit_z_n921(0);
    setup_light_unit_z_n926 <= setup_light_unit_z_n925(23 downto 0);
    setup_light_unit_z_n927 <= unsigned(setup_light_unit_z_n926(23 downto 23));
    setup_light_unit_z_n928 <= setup_light_unit_z_n927 xor setup_light_length_n42;
    setup_light_unit_z_n929 <= unsigned(setup_light_unit_z_n926);
    setup_light_unit_z_n930 <= setup_light_unit_z_n929 & setup_light_length_n43;
    setup_light_unit_z_n931 <= signed(setup_light_unit_z_n930);
    setup_light_unit_z_n973 <= setup_light_unit_z_n972_s22 & setup_light_unit_z_n921;
    setup_light_unit_z_n974 <= setup_light_unit_z_n973 & setup_light_unit_z_n928;
    -- setup.half.unit_x
    setup_half_unit_x_n1454_term <= resize(setup_half_unit_x_n1311_s22, 26) xor (25 downto 0 => setup_half_unit_x_n1450_s22(0));
    setup_half_unit_x_n1454 <= resize(setup_half_unit_x_n1453_s22, 26) + signed(setup_half_unit_x_n1454_term) + setup_half_unit_x_n1450_s22(0);
    setup_half_unit_x_n1455 <= setup_half_unit_x_n1454(23 downto 0);
    setup_half_unit_x_n1456 <= unsigned(setup_half_unit_x_n1455(23 downto 23));
    setup_half_unit_x_n1457 <= setup_half_unit_x_n1456 xor setup_light_length_n42;
    setup_half_unit_x_n1458 <= unsigned(setup_half_unit_x_n1455);
    setup_half_unit_x_n1459 <= setup_half_unit_x_n1458 & setup_light_length_n43;
    setup_half_unit_x_n1460 <= signed(setup_half_unit_x_n1459);
    setup_half_unit_x_n1461_term <= resize(setup_half_unit_x_n1311_s22, 26) xor (25 downto 0 => setup_half_unit_x_n1457(0));
    setup_half_unit_x_n1461 <= resize(setup_half_unit_x_n1460, 26) + signed(setup_half_unit_x_n1461_term) + setup_half_unit_x_n1457(0);
    setup_half_unit_x_n1462 <= setup_half_unit_x_n1461(23 downto 0);
    setup_half_unit_x_n1463 <= unsigned(setup_half_unit_x_n1462(23 downto 23));
    setup_half_unit_x_n1464 <= setup_half_unit_x_n1463 xor setup_light_length_n42;
    setup_half_unit_x_n1465 <= unsigned(setup_half_unit_x_n1462);
    setup_half_unit_x_n1466 <= setup_half_unit_x_n1465 & setup_light_length_n43;
    setup_half_unit_x_n1467 <= signed(setup_half_unit_x_n1466);
    setup_half_unit_x_n1509 <= setup_half_unit_x_n1508_s22 & setup_half_unit_x_n1457;
    setup_half_unit_x_n1510 <= setup_half_unit_x_n1509 & setup_half_unit_x_n1464;
    -- setup.half.unit_y
    setup_half_unit_y_n1669_term <= resize(setup_half_unit_x_n1311_s22, 26) xor (25 downto 0 => setup_half_unit_y_n1665_s22(0));
    setup_half_unit_y_n1669 <= resize(setup_half_unit_y_n1668_s22, 26) + signed(setup_half_unit_y_n1669_term) + setup_half_unit_y_n1665_s22(0);
    setup_half_unit_y_n1670 <= setup_half_unit_y_n1669(23 downto 0);
    setup_half_unit_y_n1671 <= unsigned(setup_half_unit_y_n1670(23 downto 23));
    setup_half_unit_y_n1672 <= setup_half_unit_y_n1671 xor setup_light_length_n42;
    setup_half_unit_y_n1673 <= unsigned(setup_half_unit_y_n1670);
    setup_half_unit_y_n1674 <= setup_half_unit_y_n1673 & setup_light_length_n43;
    setup_half_unit_y_n1675 <= signed(setup_half_unit_y_n1674);
    setup_half_unit_y_n1676_term <= resize(setup_half_unit_x_n1311_s22, 26) xor (25 downto 0 => setup_half_unit_y_n1672(0));
    setup_half_unit_y_n1676 <= resize(setup_half_unit_y_n1675, 26) + signed(setup_half_unit_y_n1676_term) + setup_half_unit_y_n1672(0);
    setup_half_unit_y_n1677 <= setup_half_unit_y_n1676(23 downto 0);
    setup_half_unit_y_n1678 <= unsigned(setup_half_unit_y_n1677(23 downto 23));
    setup_half_unit_y_n1679 <= setup_half_unit_y_n1678 xor setup_light_length_n42;
    setup_half_unit_y_n1680 <= unsigned(setup_half_unit_y_n1677);
    setup_half_unit_y_n1681 <= setup_half_unit_y_n1680 & setup_light_length_n43;
    setup_half_unit_y_n1682 <= signed(setup_half_unit_y_n1681);
    setup_half_unit_y_n1724 <= setup_half_unit_y_n1723_s22 & setup_half_unit_y_n1672;
    setup_half_unit_y_n1725 <= setup_half_unit_y_n1724 & setup_half_unit_y_n1679;
    -- setup.half.unit_z
    setup_half_unit_z_n1883_term <= resize(setup_half_unit_x_n1311_s22, 26) xor (25 downto 0 => setup_half_unit_z_n1879_s22(0));
    setup_half_unit_z_n1883 <= resize(setup_half_unit_z_n1882_s22, 26) + signed(setup_half_unit_z_n1883_term) + setup_half_unit_z_n1879_s22(0);
    setup_half_unit_z_n1884 <= setup_half_unit_z_n1883(23 downto 0);
    setup_half_unit_z_n1885 <= unsigned(setup_half_unit_z_n1884(23 downto 23));
    setup_half_unit_z_n1886 <= setup_half_unit_z_n1885 xor setup_light_length_n42;
    setup_half_unit_z_n1887 <= unsigned(setup_half_unit_z_n1884);
    setup_half_unit_z_n1888 <= setup_half_unit_z_n1887 & setup_light_length_n43;
    setup_half_unit_z_n1889 <= signed(setup_half_unit_z_n1888);
    setup_half_unit_z_n1890_term <= resize(setup_half_unit_x_n1311_s22, 26) xor (25 downto 0 => setup_half_unit_z_n1886(0));
    setup_half_unit_z_n1890 <= resize(setup_half_unit_z_n1889, 26) + signed(setup_half_unit_z_n1890_term) + setup_half_unit_z_n1886(0);
    setup_half_unit_z_n1891 <= setup_half_unit_z_n1890(23 downto 0);
    setup_half_unit_z_n1892 <= unsigned(setup_half_unit_z_n1891(23 downto 23));
    setup_half_unit_z_n1893 <= setup_half_unit_z_n1892 xor setup_light_length_n42;
    setup_half_unit_z_n1894 <= unsigned(setup_half_unit_z_n1891);
    setup_half_unit_z_n1895 <= setup_half_unit_z_n1894 & setup_light_length_n43;
    setup_half_unit_z_n1896 <= signed(setup_half_unit_z_n1895);
    setup_half_unit_z_n1938 <= setup_half_unit_z_n1937_s22 & setup_half_unit_z_n1886;
    setup_half_unit_z_n1939 <= setup_half_unit_z_n1938 & setup_half_unit_z_n1893;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_unit_x_n344_s23 <= setup_light_unit_x_n344_s22;
                setup_light_unit_x_n499_s23 <= setup_light_unit_x_n499;
                setup_light_unit_x_n502_s23 <= setup_light_unit_x_n502;
                setup_light_unit_x_n545_s23 <= setup_light_unit_x_n545;
                setup_light_unit_x_n553_s23 <= setup_light_unit_x_n553_s22;
                setup_light_unit_x_n555_s23 <= setup_light_unit_x_n555_s22;
                setup_light_unit_x_n557_s23 <= setup_light_unit_x_n557_s22;
                setup_light_unit_y_n714_s23 <= setup_light_unit_y_n714;
                setup_light_unit_y_n717_s23 <= setup_light_unit_y_n717;
                setup_light_unit_y_n760_s23 <= setup_light_unit_y_n760;
                setup_light_unit_y_n767_s23 <= setup_light_unit_y_n767_s22;
                setup_light_unit_y_n769_s23 <= setup_light_unit_y_n769_s22;
                setup_light_unit_y_n771_s23 <= setup_light_unit_y_n771_s22;
                setup_light_unit_z_n928_s23 <= setup_light_unit_z_n928;
                setup_light_unit_z_n931_s23 <= setup_light_unit_z_n931;
                setup_light_unit_z_n974_s23 <= setup_light_unit_z_n974;
                setup_light_unit_z_n981_s23 <= setup_light_unit_z_n981_s22;
                setup_light_unit_z_n983_s23 <= setup_light_unit_z_n983_s22;
                setup_light_unit_z_n985_s23 <= setup_light_unit_z_n985_s22;
                setup_half_unit_x_n1311_s23 <= setup_half_unit_x_n1311_s22;
                setup_half_unit_x_n1464_s23 <= setup_half_unit_x_n1464;
                setup_half_unit_x_n1467_s23 <= setup_half_unit_x_n1467;
                setup_half_unit_x_n1510_s23 <= setup_half_unit_x_n1510;
                setup_half_unit_x_n1518_s23 <= setup_half_unit_x_n1518_s22;
                setup_half_unit_x_n1520_s23 <= setup_half_unit_x_n1520_s22;
                setup_half_unit_x_n1522_s23 <= setup_half_unit_x_n1522_s22;
                setup_half_unit_y_n1679_s23 <= setup_half_unit_y_n1679;
                setup_half_unit_y_n1682_s23 <= setup_half_unit_y_n1682;
                setup_half_unit_y_n1725_s23 <= setup_half_unit_y_n1725;
                setup_half_unit_y_n1732_s23 <= setup_half_unit_y_n1732_s22;
                setup_half_unit_y_n1734_s23 <= setup_half_unit_y_n1734_s22;
                setup_half_unit_y_n1736_s23 <= setup_half_unit_y_n1736_s22;
                setup_half_unit_z_n1893_s23 <= setup_half_unit_z_n1893;
                setup_half_unit_z_n1896_s23 <= setup_half_unit_z_n1896;
                setup_half_unit_z_n1939_s23 <= setup_half_unit_z_n1939;
                setup_half_unit_z_n1946_s23 <= setup_half_unit_z_n1946_s22;
                setup_half_unit_z_n1948_s23 <= setup_half_unit_z_n1948_s22;
                setup_half_unit_z_n1950_s23 <= setup_half_unit_z_n1950_s22;
                setup_bump_unit_x_x_s23 <= setup_bump_unit_x_x_s22;
                setup_bump_unit_y_y_s23 <= setup_bump_unit_y_y_s22;
                setup_bump_unit_z_z_s23 <= setup_bump_unit_z_z_s22;
            end if;
            if rst = '1' then
                valid_s23 <= '0';
            elsif ce = '1' then
                valid_s23 <= valid_s22;
            end if;
        end if;
    end process;

    -- ---- stage 23 ----
    -- setup.light.unit_x
    setup_light_unit_x_n503_term <= resize(setup_light_unit_x_n344_s23, 26) xor (25 downto 0 => setup_light_unit_x_n499_s23(0));
    setup_light_unit_x_n503 <= resize(setup_light_unit_x_n502_s23, 26) + signed(setup_light_unit_x_n503_term) + setup_light_unit_x_n499_s23(0);
    setup_light_unit_x_n504 <= setup_light_unit_x_n503(23 downto 0);
    setup_light_unit_x_n505 <= unsigned(setup_light_unit_x_n504(23 downto 23));
    setup_light_unit_x_n506 <= setup_light_unit_x_n505 xor setup_light_length_n42;
    setup_light_unit_x_n507 <= unsigned(setup_light_unit_x_n504);
    setup_light_unit_x_n508 <= setup_light_unit_x_n507 & setup_light_length_n43;
    setup_light_unit_x_n509 <= signed(setup_light_unit_x_n508);
    setup_light_unit_x_n510_term <= resize(setup_light_unit_x_n344_s23, 26) xor (25 downto 0 => setup_light_unit_x_n506(0));
    setup_light_unit_x_n510 <= resize(setup_light_unit_x_n509, 26) + signed(setup_light_unit_x_n510_term) + setup_light_unit_x_n506(0);
    setup_light_unit_x_n511 <= setup_light_unit_x_n510(23 downto 0);
    setup_light_unit_x_n512 <= unsigned(setup_light_unit_x_n511(23 downto 23));
    setup_light_unit_x_n513 <= setup_light_unit_x_n512 xor setup_light_length_n42;
    setup_light_unit_x_n514 <= unsigned(setup_light_unit_x_n511);
    setup_light_unit_x_n515 <= setup_light_unit_x_n514 & setup_light_length_n43;
    setup_light_unit_x_n516 <= signed(setup_light_unit_x_n515);
    setup_light_unit_x_n546 <= setup_light_unit_x_n545_s23 & setup_light_unit_x_n506;
    setup_light_unit_x_n547 <= setup_light_unit_x_n546 & setup_light_unit_x_n513;
    -- setup.light.unit_y
    setup_light_unit_y_n718_term <= resize(setup_light_unit_x_n344_s23, 26) xor (25 downto 0 => setup_light_unit_y_n714_s23(0));
    setup_light_unit_y_n718 <= resize(setup_light_unit_y_n717_s23, 26) + signed(setup_light_unit_y_n718_term) + setup_light_unit_y_n714_s23(0);
    setup_light_unit_y_n719 <= setup_light_unit_y_n718(23 downto 0);
    setup_light_unit_y_n720 <= unsigned(setup_light_unit_y_n719(23 downto 23));
    setup_light_unit_y_n721 <= setup_light_unit_y_n720 xor setup_light_length_n42;
    setup_light_unit_y_n722 <= unsigned(setup_light_unit_y_n719);
    setup_light_unit_y_n723 <= setup_light_unit_y_n722 & setup_light_length_n43;
    setup_light_unit_y_n724 <= signed(setup_light_unit_y_n723);
    setup_light_unit_y_n725_term <= resize(setup_light_unit_x_n344_s23, 26) xor (25 downto 0 => setup_light_unit_y_n721(0));
    setup_light_unit_y_n725 <= resize(setup_light_unit_y_n724, 26) + signed(setup_light_unit_y_n725_term) + setup_light_unit_y_n721(0);
    setup_light_unit_y_n726 <= setup_light_unit_y_n725(23 downto 0);
    setup_light_unit_y_n727 <= unsigned(setup_light_unit_y_n726(23 downto 23));
    setup_light_unit_y_n728 <= setup_light_unit_y_n727 xor setup_light_length_n42;
    setup_light_unit_y_n729 <= unsigned(setup_light_unit_y_n726);
    setup_light_unit_y_n730 <= setup_light_unit_y_n729 & setup_light_length_n43;
    setup_light_unit_y_n731 <= signed(setup_light_unit_y_n730);
    setup_light_unit_y_n761 <= setup_light_unit_y_n760_s23 & setup_light_unit_y_n721;
    setup_light_unit_y_n762 <= setup_light_unit_y_n761 & setup_light_unit_y_n728;
    -- setup.light.unit_z
    setup_light_unit_z_n932_term <= resize(setup_light_unit_x_n344_s23, 26) xor (25 downto 0 => setup_light_unit_z_n928_s23(0));
    setup_light_unit_z_n932 <= resize(setup_light_unit_z_n931_s23, 26) + signed(setup_light_unit_z_n932_term) + setup_light_unit_z_n928_s23(0);
    setup_light_unit_z_n933 <= setup_light_unit_z_n932(23 downto 0);
    setup_light_unit_z_n934 <= unsigned(setup_light_unit_z_n933(23 downto 23));
    setup_light_unit_z_n935 <= setup_light_unit_z_n934 xor setup_light_length_n42;
    setup_light_unit_z_n936 <= unsigned(setup_light_unit_z_n933);
    setup_light_unit_z_n937 <= setup_light_unit_z_n936 & setup_light_length_n43;
    setup_light_unit_z_n938 <= signed(setup_light_unit_z_n937);
    setup_light_unit_z_n939_term <= resize(setup_light_unit_x_n344_s23, 26) xor (25 downto 0 => setup_light_unit_z_n935(0));
    setup_light_unit_z_n939 <= resize(setup_light_unit_z_n938, 26) + signed(setup_light_unit_z_n939_term) + setup_light_unit_z_n935(0);
    setup_light_unit_z_n940 <= setup_light_unit_z_n939(23 downto 0);
    setup_light_unit_z_n941 <= unsigned(setup_light_unit_z_n940(23 downto 23));
    setup_light_unit_z_n942 <= setup_light_unit_z_n941 xor setup_light_length_n42;
    setup_light_unit_z_n943 <= unsigned(setup_light_unit_z_n940);
    setup_light_unit_z_n944 <= setup_light_unit_z_n943 & setup_light_length_n43;
    setup_light_unit_z_n945 <= signed(setup_light_unit_z_n944);
    setup_light_unit_z_n975 <= setup_light_unit_z_n974_s23 & setup_light_unit_z_n935;
    setup_light_unit_z_n976 <= setup_light_unit_z_n975 & setup_light_unit_z_n942;
    -- setup.half.unit_x
    setup_half_unit_x_n1468_term <= resize(setup_half_unit_x_n1311_s23, 26) xor (25 downto 0 => setup_half_unit_x_n1464_s23(0));
    setup_half_unit_x_n1468 <= resize(setup_half_unit_x_n1467_s23, 26) + signed(setup_half_unit_x_n1468_term) + setup_half_unit_x_n1464_s23(0);
    setup_half_unit_x_n1469 <= setup_half_unit_x_n1468(23 downto 0);
    setup_half_unit_x_n1470 <= unsigned(setup_half_unit_x_n1469(23 downto 23));
    setup_half_unit_x_n1471 <= setup_half_unit_x_n1470 xor setup_light_length_n42;
    setup_half_unit_x_n1472 <= unsigned(setup_half_unit_x_n1469);
    setup_half_unit_x_n1473 <= setup_half_unit_x_n1472 & setup_light_length_n43;
    setup_half_unit_x_n1474 <= signed(setup_half_unit_x_n1473);
    setup_half_unit_x_n1475_term <= resize(setup_half_unit_x_n1311_s23, 26) xor (25 downto 0 => setup_half_unit_x_n1471(0));
    setup_half_unit_x_n1475 <= resize(setup_half_unit_x_n1474, 26) + signed(setup_half_unit_x_n1475_term) + setup_half_unit_x_n1471(0);
    setup_half_unit_x_n1476 <= setup_half_unit_x_n1475(23 downto 0);
    setup_half_unit_x_n1477 <= unsigned(setup_half_unit_x_n1476(23 downto 23));
    setup_half_unit_x_n1478 <= setup_half_unit_x_n1477 xor setup_light_length_n42;
    setup_half_unit_x_n1479 <= unsigned(setup_half_unit_x_n1476);
    setup_half_unit_x_n1480 <= setup_half_unit_x_n1479 & setup_light_length_n43;
    setup_half_unit_x_n1481 <= signed(setup_half_unit_x_n1480);
    setup_half_unit_x_n1511 <= setup_half_unit_x_n1510_s23 & setup_half_unit_x_n1471;
    setup_half_unit_x_n1512 <= setup_half_unit_x_n1511 & setup_half_unit_x_n1478;
    -- setup.half.unit_y
    setup_half_unit_y_n1683_term <= resize(setup_half_unit_x_n1311_s23, 26) xor (25 downto 0 => setup_half_unit_y_n1679_s23(0));
    setup_half_unit_y_n1683 <= resize(setup_half_unit_y_n1682_s23, 26) + signed(setup_half_unit_y_n1683_term) + setup_half_unit_y_n1679_s23(0);
    setup_half_unit_y_n1684 <= setup_half_unit_y_n1683(23 downto 0);
    setup_half_unit_y_n1685 <= unsigned(setup_half_unit_y_n1684(23 downto 23));
    setup_half_unit_y_n1686 <= setup_half_unit_y_n1685 xor setup_light_length_n42;
    setup_half_unit_y_n1687 <= unsigned(setup_half_unit_y_n1684);
    setup_half_unit_y_n1688 <= setup_half_unit_y_n1687 & setup_light_length_n43;
    setup_half_unit_y_n1689 <= signed(setup_half_unit_y_n1688);
    setup_half_unit_y_n1690_term <= resize(setup_half_unit_x_n1311_s23, 26) xor (25 downto 0 => setup_half_unit_y_n1686(0));
    setup_half_unit_y_n1690 <= resize(setup_half_unit_y_n1689, 26) + signed(setup_half_unit_y_n1690_term) + setup_half_unit_y_n1686(0);
    setup_half_unit_y_n1691 <= setup_half_unit_y_n1690(23 downto 0);
    setup_half_unit_y_n1692 <= unsigned(setup_half_unit_y_n1691(23 downto 23));
    setup_half_unit_y_n1693 <= setup_half_unit_y_n1692 xor setup_light_length_n42;
    setup_half_unit_y_n1694 <= unsigned(setup_half_unit_y_n1691);
    setup_half_unit_y_n1695 <= setup_half_unit_y_n1694 & setup_light_length_n43;
    setup_half_unit_y_n1696 <= signed(setup_half_unit_y_n1695);
    setup_half_unit_y_n1726 <= setup_half_unit_y_n1725_s23 & setup_half_unit_y_n1686;
    setup_half_unit_y_n1727 <= setup_half_unit_y_n1726 & setup_half_unit_y_n1693;
    -- setup.half.unit_z
    setup_half_unit_z_n1897_term <= resize(setup_half_unit_x_n1311_s23, 26) xor (25 downto 0 => setup_half_unit_z_n1893_s23(0));
    setup_half_unit_z_n1897 <= resize(setup_half_unit_z_n1896_s23, 26) + signed(setup_half_unit_z_n1897_term) + setup_half_unit_z_n1893_s23(0);
    setup_half_unit_z_n1898 <= setup_half_unit_z_n1897(23 downto 0);
    setup_half_unit_z_n1899 <= unsigned(setup_half_unit_z_n1898(23 downto 23));
    setup_half_unit_z_n1900 <= setup_half_unit_z_n1899 xor setup_light_length_n42;
    setup_half_unit_z_n1901 <= unsigned(setup_half_unit_z_n1898);
    setup_half_unit_z_n1902 <= setup_half_unit_z_n1901 & setup_light_length_n43;
    setup_half_unit_z_n1903 <= signed(setup_half_unit_z_n1902);
    setup_half_unit_z_n1904_term <= resize(setup_half_unit_x_n1311_s23, 26) xor (25 downto 0 => setup_half_unit_z_n1900(0));
    setup_half_unit_z_n1904 <= resize(setup_half_unit_z_n1903, 26) + signed(setup_half_unit_z_n1904_term) + setup_half_unit_z_n1900(0);
    setup_half_unit_z_n1905 <= setup_half_unit_z_n1904(23 downto 0);
    setup_half_unit_z_n1906 <= unsigned(setup_half_unit_z_n1905(23 downto 23));
    setup_half_unit_z_n1907 <= setup_half_unit_z_n1906 xor setup_light_length_n42;
    setup_half_unit_z_n1908 <= unsigned(setup_half_unit_z_n1905);
    setup_half_unit_z_n1909 <= setup_half_unit_z_n1908 & setup_light_length_n43;
    setup_half_unit_z_n1910 <= signed(setup_half_unit_z_n1909);
    setup_half_unit_z_n1940 <= setup_half_unit_z_n1939_s23 & setup_half_unit_z_n1900;
    setup_half_unit_z_n1941 <= setup_half_unit_z_n1940 & setup_half_unit_z_n1907;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_unit_x_n344_s24 <= setup_light_unit_x_n344_s23;
                setup_light_unit_x_n513_s24 <= setup_light_unit_x_n513;
                setup_light_unit_x_n516_s24 <= setup_light_unit_x_n516;
                setup_light_unit_x_n547_s24 <= setup_light_unit_x_n547;
                setup_light_unit_x_n553_s24 <= setup_light_unit_x_n553_s23;
                setup_light_unit_x_n555_s24 <= setup_light_unit_x_n555_s23;
                setup_light_unit_x_n557_s24 <= setup_light_unit_x_n557_s23;
                setup_light_unit_y_n728_s24 <= setup_light_unit_y_n728;
                setup_light_unit_y_n731_s24 <= setup_light_unit_y_n731;
                setup_light_unit_y_n762_s24 <= setup_light_unit_y_n762;
                setup_light_unit_y_n767_s24 <= setup_light_unit_y_n767_s23;
                setup_light_unit_y_n769_s24 <= setup_light_unit_y_n769_s23;
                setup_light_unit_y_n771_s24 <= setup_light_unit_y_n771_s23;
                setup_light_unit_z_n942_s24 <= setup_light_unit_z_n942;
                setup_light_unit_z_n945_s24 <= setup_light_unit_z_n945;
                setup_light_unit_z_n976_s24 <= setup_light_unit_z_n976;
                setup_light_unit_z_n981_s24 <= setup_light_unit_z_n981_s23;
                setup_light_unit_z_n983_s24 <= setup_light_unit_z_n983_s23;
                setup_light_unit_z_n985_s24 <= setup_light_unit_z_n985_s23;
                setup_half_unit_x_n1311_s24 <= setup_half_unit_x_n1311_s23;
                setup_half_unit_x_n1478_s24 <= setup_half_unit_x_n1478;
                setup_half_unit_x_n1481_s24 <= setup_half_unit_x_n1481;
                setup_half_unit_x_n1512_s24 <= setup_half_unit_x_n1512;
                setup_half_unit_x_n1518_s24 <= setup_half_unit_x_n1518_s23;
                setup_half_unit_x_n1520_s24 <= setup_half_unit_x_n1520_s23;
                setup_half_unit_x_n1522_s24 <= setup_half_unit_x_n1522_s23;
                setup_half_unit_y_n1693_s24 <= setup_half_unit_y_n1693;
                setup_half_unit_y_n1696_s24 <= setup_half_unit_y_n1696;
                setup_half_unit_y_n1727_s24 <= setup_half_unit_y_n1727;
                setup_half_unit_y_n1732_s24 <= setup_half_unit_y_n1732_s23;
                setup_half_unit_y_n1734_s24 <= setup_half_unit_y_n1734_s23;
                setup_half_unit_y_n1736_s24 <= setup_half_unit_y_n1736_s23;
                setup_half_unit_z_n1907_s24 <= setup_half_unit_z_n1907;
                setup_half_unit_z_n1910_s24 <= setup_half_unit_z_n1910;
                setup_half_unit_z_n1941_s24 <= setup_half_unit_z_n1941;
                setup_half_unit_z_n1946_s24 <= setup_half_unit_z_n1946_s23;
                setup_half_unit_z_n1948_s24 <= setup_half_unit_z_n1948_s23;
                setup_half_unit_z_n1950_s24 <= setup_half_unit_z_n1950_s23;
                setup_bump_unit_x_x_s24 <= setup_bump_unit_x_x_s23;
                setup_bump_unit_y_y_s24 <= setup_bump_unit_y_y_s23;
                setup_bump_unit_z_z_s24 <= setup_bump_unit_z_z_s23;
            end if;
            if rst = '1' then
                valid_s24 <= '0';
            elsif ce = '1' then
                valid_s24 <= valid_s23;
            end if;
        end if;
    end process;

    -- ---- stage 24 ----
    -- setup.light.unit_x
    setup_light_unit_x_n517_term <= resize(setup_light_unit_x_n344_s24, 26) xor (25 downto 0 => setup_light_unit_x_n513_s24(0));
    setup_light_unit_x_n517 <= resize(setup_light_unit_x_n516_s24, 26) + signed(setup_light_unit_x_n517_term) + setup_light_unit_x_n513_s24(0);
    setup_light_unit_x_n518 <= setup_light_unit_x_n517(23 downto 0);
    setup_light_unit_x_n519 <= unsigned(setup_light_unit_x_n518(23 downto 23));
    setup_light_unit_x_n520 <= setup_light_unit_x_n519 xor setup_light_length_n42;
    setup_light_unit_x_n521 <= unsigned(setup_light_unit_x_n518);
    setup_light_unit_x_n522 <= setup_light_unit_x_n521 & setup_light_length_n43;
    setup_light_unit_x_n523 <= signed(setup_light_unit_x_n522);
    setup_light_unit_x_n524_term <= resize(setup_light_unit_x_n344_s24, 26) xor (25 downto 0 => setup_light_unit_x_n520(0));
    setup_light_unit_x_n524 <= resize(setup_light_unit_x_n523, 26) + signed(setup_light_unit_x_n524_term) + setup_light_unit_x_n520(0);
    setup_light_unit_x_n525 <= setup_light_unit_x_n524(23 downto 0);
    setup_light_unit_x_n526 <= unsigned(setup_light_unit_x_n525(23 downto 23));
    setup_light_unit_x_n527 <= setup_light_unit_x_n526 xor setup_light_length_n42;
    setup_light_unit_x_n528 <= resize(setup_light_unit_x_n525, 25) + signed(resize(setup_light_unit_x_n344_s24, 25));
    setup_light_unit_x_n548 <= setup_light_unit_x_n547_s24 & setup_light_unit_x_n520;
    setup_light_unit_x_n549 <= setup_light_unit_x_n548 & setup_light_unit_x_n527;
    -- setup.light.unit_y
    setup_light_unit_y_n732_term <= resize(setup_light_unit_x_n344_s24, 26) xor (25 downto 0 => setup_light_unit_y_n728_s24(0));
    setup_light_unit_y_n732 <= resize(setup_light_unit_y_n731_s24, 26) + signed(setup_light_unit_y_n732_term) + setup_light_unit_y_n728_s24(0);
    setup_light_unit_y_n733 <= setup_light_unit_y_n732(23 downto 0);
    setup_light_unit_y_n734 <= unsigned(setup_light_unit_y_n733(23 downto 23));
    setup_light_unit_y_n735 <= setup_light_unit_y_n734 xor setup_light_length_n42;
    setup_light_unit_y_n736 <= unsigned(setup_light_unit_y_n733);
    setup_light_unit_y_n737 <= setup_light_unit_y_n736 & setup_light_length_n43;
    setup_light_unit_y_n738 <= signed(setup_light_unit_y_n737);
    setup_light_unit_y_n739_term <= resize(setup_light_unit_x_n344_s24, 26) xor (25 downto 0 => setup_light_unit_y_n735(0));
    setup_light_unit_y_n739 <= resize(setup_light_unit_y_n738, 26) + signed(setup_light_unit_y_n739_term) + setup_light_unit_y_n735(0);
    setup_light_unit_y_n740 <= setup_light_unit_y_n739(23 downto 0);
    setup_light_unit_y_n741 <= unsigned(setup_light_unit_y_n740(23 downto 23));
    setup_light_unit_y_n742 <= setup_light_unit_y_n741 xor setup_light_length_n42;
    setup_light_unit_y_n743 <= resize(setup_light_unit_y_n740, 25) + signed(resize(setup_light_unit_x_n344_s24, 25));
    setup_light_unit_y_n763 <= setup_light_unit_y_n762_s24 & setup_light_unit_y_n735;
    setup_light_unit_y_n764 <= setup_light_unit_y_n763 & setup_light_unit_y_n742;
    -- setup.light.unit_z
    setup_light_unit_z_n946_term <= resize(setup_light_unit_x_n344_s24, 26) xor (25 downto 0 => setup_light_unit_z_n942_s24(0));
    setup_light_unit_z_n946 <= resize(setup_light_unit_z_n945_s24, 26) + signed(setup_light_unit_z_n946_term) + setup_light_unit_z_n942_s24(0);
    setup_light_unit_z_n947 <= setup_light_unit_z_n946(23 downto 0);
    setup_light_unit_z_n948 <= unsigned(setup_light_unit_z_n947(23 downto 23));
    setup_light_unit_z_n949 <= setup_light_unit_z_n948 xor setup_light_length_n42;
    setup_light_unit_z_n950 <= unsigned(setup_light_unit_z_n947);
    setup_light_unit_z_n951 <= setup_light_unit_z_n950 & setup_light_length_n43;
    setup_light_unit_z_n952 <= signed(setup_light_unit_z_n951);
    setup_light_unit_z_n953_term <= resize(setup_light_unit_x_n344_s24, 26) xor (25 downto 0 => setup_light_unit_z_n949(0));
    setup_light_unit_z_n953 <= resize(setup_light_unit_z_n952, 26) + signed(setup_light_unit_z_n953_term) + setup_light_unit_z_n949(0);
    setup_light_unit_z_n954 <= setup_light_unit_z_n953(23 downto 0);
    setup_light_unit_z_n955 <= unsigned(setup_light_unit_z_n954(23 downto 23));
    setup_light_unit_z_n956 <= setup_light_unit_z_n955 xor setup_light_length_n42;
    setup_light_unit_z_n957 <= resize(setup_light_unit_z_n954, 25) + signed(resize(setup_light_unit_x_n344_s24, 25));
    setup_light_unit_z_n977 <= setup_light_unit_z_n976_s24 & setup_light_unit_z_n949;
    setup_light_unit_z_n978 <= setup_light_unit_z_n977 & setup_light_unit_z_n956;
    -- setup.half.unit_x
    setup_half_unit_x_n1482_term <= resize(setup_half_unit_x_n1311_s24, 26) xor (25 downto 0 => setup_half_unit_x_n1478_s24(0));
    setup_half_unit_x_n1482 <= resize(setup_half_unit_x_n1481_s24, 26) + signed(setup_half_unit_x_n1482_term) + setup_half_unit_x_n1478_s24(0);
    setup_half_unit_x_n1483 <= setup_half_unit_x_n1482(23 downto 0);
    setup_half_unit_x_n1484 <= unsigned(setup_half_unit_x_n1483(23 downto 23));
    setup_half_unit_x_n1485 <= setup_half_unit_x_n1484 xor setup_light_length_n42;
    setup_half_unit_x_n1486 <= unsigned(setup_half_unit_x_n1483);
    setup_half_unit_x_n1487 <= setup_half_unit_x_n1486 & setup_light_length_n43;
    setup_half_unit_x_n1488 <= signed(setup_half_unit_x_n1487);
    setup_half_unit_x_n1489_term <= resize(setup_half_unit_x_n1311_s24, 26) xor (25 downto 0 => setup_half_unit_x_n1485(0));
    setup_half_unit_x_n1489 <= resize(setup_half_unit_x_n1488, 26) + signed(setup_half_unit_x_n1489_term) + setup_half_unit_x_n1485(0);
    setup_half_unit_x_n1490 <= setup_half_unit_x_n1489(23 downto 0);
    setup_half_unit_x_n1491 <= unsigned(setup_half_unit_x_n1490(23 downto 23));
    setup_half_unit_x_n1492 <= setup_half_unit_x_n1491 xor setup_light_length_n42;
    setup_half_unit_x_n1493 <= resize(setup_half_unit_x_n1490, 25) + signed(resize(setup_half_unit_x_n1311_s24, 25));
    setup_half_unit_x_n1513 <= setup_half_unit_x_n1512_s24 & setup_half_unit_x_n1485;
    setup_half_unit_x_n1514 <= setup_half_unit_x_n1513 & setup_half_unit_x_n1492;
    -- setup.half.unit_y
    setup_half_unit_y_n1697_term <= resize(setup_half_unit_x_n1311_s24, 26) xor (25 downto 0 => setup_half_unit_y_n1693_s24(0));
    setup_half_unit_y_n1697 <= resize(setup_half_unit_y_n1696_s24, 26) + signed(setup_half_unit_y_n1697_term) + setup_half_unit_y_n1693_s24(0);
    setup_half_unit_y_n1698 <= setup_half_unit_y_n1697(23 downto 0);
    setup_half_unit_y_n1699 <= unsigned(setup_half_unit_y_n1698(23 downto 23));
    setup_half_unit_y_n1700 <= setup_half_unit_y_n1699 xor setup_light_length_n42;
    setup_half_unit_y_n1701 <= unsigned(setup_half_unit_y_n1698);
    setup_half_unit_y_n1702 <= setup_half_unit_y_n1701 & setup_light_length_n43;
    setup_half_unit_y_n1703 <= signed(setup_half_unit_y_n1702);
    setup_half_unit_y_n1704_term <= resize(setup_half_unit_x_n1311_s24, 26) xor (25 downto 0 => setup_half_unit_y_n1700(0));
    setup_half_unit_y_n1704 <= resize(setup_half_unit_y_n1703, 26) + signed(setup_half_unit_y_n1704_term) + setup_half_unit_y_n1700(0);
    setup_half_unit_y_n1705 <= setup_half_unit_y_n1704(23 downto 0);
    setup_half_unit_y_n1706 <= unsigned(setup_half_unit_y_n1705(23 downto 23));
    setup_half_unit_y_n1707 <= setup_half_unit_y_n1706 xor setup_light_length_n42;
    setup_half_unit_y_n1708 <= resize(setup_half_unit_y_n1705, 25) + signed(resize(setup_half_unit_x_n1311_s24, 25));
    setup_half_unit_y_n1728 <= setup_half_unit_y_n1727_s24 & setup_half_unit_y_n1700;
    setup_half_unit_y_n1729 <= setup_half_unit_y_n1728 & setup_half_unit_y_n1707;
    -- setup.half.unit_z
    setup_half_unit_z_n1911_term <= resize(setup_half_unit_x_n1311_s24, 26) xor (25 downto 0 => setup_half_unit_z_n1907_s24(0));
    setup_half_unit_z_n1911 <= resize(setup_half_unit_z_n1910_s24, 26) + signed(setup_half_unit_z_n1911_term) + setup_half_unit_z_n1907_s24(0);
    setup_half_unit_z_n1912 <= setup_half_unit_z_n1911(23 downto 0);
    setup_half_unit_z_n1913 <= unsigned(setup_half_unit_z_n1912(23 downto 23));
    setup_half_unit_z_n1914 <= setup_half_unit_z_n1913 xor setup_light_length_n42;
    setup_half_unit_z_n1915 <= unsigned(setup_half_unit_z_n1912);
    setup_half_unit_z_n1916 <= setup_half_unit_z_n1915 & setup_light_length_n43;
    setup_half_unit_z_n1917 <= signed(setup_half_unit_z_n1916);
    setup_half_unit_z_n1918_term <= resize(setup_half_unit_x_n1311_s24, 26) xor (25 downto 0 => setup_half_unit_z_n1914(0));
    setup_half_unit_z_n1918 <= resize(setup_half_unit_z_n1917, 26) + signed(setup_half_unit_z_n1918_term) + setup_half_unit_z_n1914(0);
    setup_half_unit_z_n1919 <= setup_half_unit_z_n1918(23 downto 0);
    setup_half_unit_z_n1920 <= unsigned(setup_half_unit_z_n1919(23 downto 23));
    setup_half_unit_z_n1921 <= setup_half_unit_z_n1920 xor setup_light_length_n42;
    setup_half_unit_z_n1922 <= resize(setup_half_unit_z_n1919, 25) + signed(resize(setup_half_unit_x_n1311_s24, 25));
    setup_half_unit_z_n1942 <= setup_half_unit_z_n1941_s24 & setup_half_unit_z_n1914;
    setup_half_unit_z_n1943 <= setup_half_unit_z_n1942 & setup_half_unit_z_n1921;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_unit_x_n525_s25 <= setup_light_unit_x_n525;
                setup_light_unit_x_n526_s25 <= setup_light_unit_x_n526;
                setup_light_unit_x_n528_s25 <= setup_light_unit_x_n528;
                setup_light_unit_x_n549_s25 <= setup_light_unit_x_n549;
                setup_light_unit_x_n553_s25 <= setup_light_unit_x_n553_s24;
                setup_light_unit_x_n555_s25 <= setup_light_unit_x_n555_s24;
                setup_light_unit_x_n557_s25 <= setup_light_unit_x_n557_s24;
                setup_light_unit_y_n740_s25 <= setup_light_unit_y_n740;
                setup_light_unit_y_n741_s25 <= setup_light_unit_y_n741;
                setup_light_unit_y_n743_s25 <= setup_light_unit_y_n743;
                setup_light_unit_y_n764_s25 <= setup_light_unit_y_n764;
                setup_light_unit_y_n767_s25 <= setup_light_unit_y_n767_s24;
                setup_light_unit_y_n769_s25 <= setup_light_unit_y_n769_s24;
                setup_light_unit_y_n771_s25 <= setup_light_unit_y_n771_s24;
                setup_light_unit_z_n954_s25 <= setup_light_unit_z_n954;
                setup_light_unit_z_n955_s25 <= setup_light_unit_z_n955;
                setup_light_unit_z_n957_s25 <= setup_light_unit_z_n957;
                setup_light_unit_z_n978_s25 <= setup_light_unit_z_n978;
                setup_light_unit_z_n981_s25 <= setup_light_unit_z_n981_s24;
                setup_light_unit_z_n983_s25 <= setup_light_unit_z_n983_s24;
                setup_light_unit_z_n985_s25 <= setup_light_unit_z_n985_s24;
                setup_half_unit_x_n1490_s25 <= setup_half_unit_x_n1490;
                setup_half_unit_x_n1491_s25 <= setup_half_unit_x_n1491;
                setup_half_unit_x_n1493_s25 <= setup_half_unit_x_n1493;
                setup_half_unit_x_n1514_s25 <= setup_half_unit_x_n1514;
                setup_half_unit_x_n1518_s25 <= setup_half_unit_x_n1518_s24;
                setup_half_unit_x_n1520_s25 <= setup_half_unit_x_n1520_s24;
                setup_half_unit_x_n1522_s25 <= setup_half_unit_x_n1522_s24;
                setup_half_unit_y_n1705_s25 <= setup_half_unit_y_n1705;
                setup_half_unit_y_n1706_s25 <= setup_half_unit_y_n1706;
                setup_half_unit_y_n1708_s25 <= setup_half_unit_y_n1708;
                setup_half_unit_y_n1729_s25 <= setup_half_unit_y_n1729;
                setup_half_unit_y_n1732_s25 <= setup_half_unit_y_n1732_s24;
                setup_half_unit_y_n1734_s25 <= setup_half_unit_y_n1734_s24;
                setup_half_unit_y_n1736_s25 <= setup_half_unit_y_n1736_s24;
                setup_half_unit_z_n1919_s25 <= setup_half_unit_z_n1919;
                setup_half_unit_z_n1920_s25 <= setup_half_unit_z_n1920;
                setup_half_unit_z_n1922_s25 <= setup_half_unit_z_n1922;
                setup_half_unit_z_n1943_s25 <= setup_half_unit_z_n1943;
                setup_half_unit_z_n1946_s25 <= setup_half_unit_z_n1946_s24;
                setup_half_unit_z_n1948_s25 <= setup_half_unit_z_n1948_s24;
                setup_half_unit_z_n1950_s25 <= setup_half_unit_z_n1950_s24;
                setup_bump_unit_x_x_s25 <= setup_bump_unit_x_x_s24;
                setup_bump_unit_y_y_s25 <= setup_bump_unit_y_y_s24;
                setup_bump_unit_z_z_s25 <= setup_bump_unit_z_z_s24;
            end if;
            if rst = '1' then
                valid_s25 <= '0';
            elsif ce = '1' then
                valid_s25 <= valid_s24;
            end if;
        end if;
    end process;

    -- ---- stage 25 ----
    -- setup.light.unit_x
    setup_light_unit_x_n529 <= setup_light_unit_x_n528_s25 when setup_light_unit_x_n526_s25(0) = '1' else resize(setup_light_unit_x_n525_s25, 25);
    setup_light_unit_x_n530 <= "1" when unsigned(setup_light_unit_x_n529) = resize(setup_light_length_n43, 25) else "0";
    setup_light_unit_x_n531 <= setup_light_unit_x_n530 xor setup_light_length_n42;
    setup_light_unit_x_n550 <= setup_light_unit_x_n549_s25 & setup_light_unit_x_n531;
    setup_light_unit_x_n551 <= setup_light_unit_x_n550;
    setup_light_unit_x_n554 <= shift_left(resize(setup_light_unit_x_n343, 20), 19) when setup_light_unit_x_n553_s25(0) = '1' else setup_light_unit_x_n551;
    setup_light_unit_x_n556 <= shift_left(resize(setup_light_length_n43, 20), 18) when setup_light_unit_x_n555_s25(0) = '1' else setup_light_unit_x_n554;
    setup_light_unit_x_n558 <= -signed(resize(setup_light_unit_x_n556, 21));
    -- setup.light.unit_y
    setup_light_unit_y_n744 <= setup_light_unit_y_n743_s25 when setup_light_unit_y_n741_s25(0) = '1' else resize(setup_light_unit_y_n740_s25, 25);
    setup_light_unit_y_n745 <= "1" when unsigned(setup_light_unit_y_n744) = resize(setup_light_length_n43, 25) else "0";
    setup_light_unit_y_n746 <= setup_light_unit_y_n745 xor setup_light_length_n42;
    setup_light_unit_y_n765 <= setup_light_unit_y_n764_s25 & setup_light_unit_y_n746;
    setup_light_unit_y_n766 <= setup_light_unit_y_n765;
    setup_light_unit_y_n768 <= shift_left(resize(setup_light_unit_x_n343, 20), 19) when setup_light_unit_y_n767_s25(0) = '1' else setup_light_unit_y_n766;
    setup_light_unit_y_n770 <= shift_left(resize(setup_light_length_n43, 20), 18) when setup_light_unit_y_n769_s25(0) = '1' else setup_light_unit_y_n768;
    setup_light_unit_y_n772 <= -signed(resize(setup_light_unit_y_n770, 21));
    -- setup.light.unit_z
    setup_light_unit_z_n958 <= setup_light_unit_z_n957_s25 when setup_light_unit_z_n955_s25(0) = '1' else resize(setup_light_unit_z_n954_s25, 25);
    setup_light_unit_z_n959 <= "1" when unsigned(setup_light_unit_z_n958) = resize(setup_light_length_n43, 25) else "0";
    setup_light_unit_z_n960 <= setup_light_unit_z_n959 xor setup_light_length_n42;
    setup_light_unit_z_n979 <= setup_light_unit_z_n978_s25 & setup_light_unit_z_n960;
    setup_light_unit_z_n980 <= setup_light_unit_z_n979;
    setup_light_unit_z_n982 <= shift_left(resize(setup_light_unit_x_n343, 20), 19) when setup_light_unit_z_n981_s25(0) = '1' else setup_light_unit_z_n980;
    setup_light_unit_z_n984 <= shift_left(resize(setup_light_length_n43, 20), 18) when setup_light_unit_z_n983_s25(0) = '1' else setup_light_unit_z_n982;
    setup_light_unit_z_n986 <= -signed(resize(setup_light_unit_z_n984, 21));
    -- setup.half.unit_x
    setup_half_unit_x_n1494 <= setup_half_unit_x_n1493_s25 when setup_half_unit_x_n1491_s25(0) = '1' else resize(setup_half_unit_x_n1490_s25, 25);
    setup_half_unit_x_n1495 <= "1" when unsigned(setup_half_unit_x_n1494) = resize(setup_light_length_n43, 25) else "0";
    setup_half_unit_x_n1496 <= setup_half_unit_x_n1495 xor setup_light_length_n42;
    setup_half_unit_x_n1515 <= setup_half_unit_x_n1514_s25 & setup_half_unit_x_n1496;
    setup_half_unit_x_n1516 <= setup_half_unit_x_n1515;
    setup_half_unit_x_n1519 <= shift_left(resize(setup_light_unit_x_n343, 20), 19) when setup_half_unit_x_n1518_s25(0) = '1' else setup_half_unit_x_n1516;
    setup_half_unit_x_n1521 <= shift_left(resize(setup_light_length_n43, 20), 18) when setup_half_unit_x_n1520_s25(0) = '1' else setup_half_unit_x_n1519;
    setup_half_unit_x_n1523 <= -signed(resize(setup_half_unit_x_n1521, 21));
    -- setup.half.unit_y
    setup_half_unit_y_n1709 <= setup_half_unit_y_n1708_s25 when setup_half_unit_y_n1706_s25(0) = '1' else resize(setup_half_unit_y_n1705_s25, 25);
    setup_half_unit_y_n1710 <= "1" when unsigned(setup_half_unit_y_n1709) = resize(setup_light_length_n43, 25) else "0";
    setup_half_unit_y_n1711 <= setup_half_unit_y_n1710 xor setup_light_length_n42;
    setup_half_unit_y_n1730 <= setup_half_unit_y_n1729_s25 & setup_half_unit_y_n1711;
    setup_half_unit_y_n1731 <= setup_half_unit_y_n1730;
    setup_half_unit_y_n1733 <= shift_left(resize(setup_light_unit_x_n343, 20), 19) when setup_half_unit_y_n1732_s25(0) = '1' else setup_half_unit_y_n1731;
    setup_half_unit_y_n1735 <= shift_left(resize(setup_light_length_n43, 20), 18) when setup_half_unit_y_n1734_s25(0) = '1' else setup_half_unit_y_n1733;
    setup_half_unit_y_n1737 <= -signed(resize(setup_half_unit_y_n1735, 21));
    -- setup.half.unit_z
    setup_half_unit_z_n1923 <= setup_half_unit_z_n1922_s25 when setup_half_unit_z_n1920_s25(0) = '1' else resize(setup_half_unit_z_n1919_s25, 25);
    setup_half_unit_z_n1924 <= "1" when unsigned(setup_half_unit_z_n1923) = resize(setup_light_length_n43, 25) else "0";
    setup_half_unit_z_n1925 <= setup_half_unit_z_n1924 xor setup_light_length_n42;
    setup_half_unit_z_n1944 <= setup_half_unit_z_n1943_s25 & setup_half_unit_z_n1925;
    setup_half_unit_z_n1945 <= setup_half_unit_z_n1944;
    setup_half_unit_z_n1947 <= shift_left(resize(setup_light_unit_x_n343, 20), 19) when setup_half_unit_z_n1946_s25(0) = '1' else setup_half_unit_z_n1945;
    setup_half_unit_z_n1949 <= shift_left(resize(setup_light_length_n43, 20), 18) when setup_half_unit_z_n1948_s25(0) = '1' else setup_half_unit_z_n1947;
    setup_half_unit_z_n1951 <= -signed(resize(setup_half_unit_z_n1949, 21));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_unit_x_n556_s26 <= setup_light_unit_x_n556;
                setup_light_unit_x_n557_s26 <= setup_light_unit_x_n557_s25;
                setup_light_unit_x_n558_s26 <= setup_light_unit_x_n558;
                setup_light_unit_y_n770_s26 <= setup_light_unit_y_n770;
                setup_light_unit_y_n771_s26 <= setup_light_unit_y_n771_s25;
                setup_light_unit_y_n772_s26 <= setup_light_unit_y_n772;
                setup_light_unit_z_n984_s26 <= setup_light_unit_z_n984;
                setup_light_unit_z_n985_s26 <= setup_light_unit_z_n985_s25;
                setup_light_unit_z_n986_s26 <= setup_light_unit_z_n986;
                setup_half_unit_x_n1521_s26 <= setup_half_unit_x_n1521;
                setup_half_unit_x_n1522_s26 <= setup_half_unit_x_n1522_s25;
                setup_half_unit_x_n1523_s26 <= setup_half_unit_x_n1523;
                setup_half_unit_y_n1735_s26 <= setup_half_unit_y_n1735;
                setup_half_unit_y_n1736_s26 <= setup_half_unit_y_n1736_s25;
                setup_half_unit_y_n1737_s26 <= setup_half_unit_y_n1737;
                setup_half_unit_z_n1949_s26 <= setup_half_unit_z_n1949;
                setup_half_unit_z_n1950_s26 <= setup_half_unit_z_n1950_s25;
                setup_half_unit_z_n1951_s26 <= setup_half_unit_z_n1951;
                setup_bump_unit_x_x_s26 <= setup_bump_unit_x_x_s25;
                setup_bump_unit_y_y_s26 <= setup_bump_unit_y_y_s25;
                setup_bump_unit_z_z_s26 <= setup_bump_unit_z_z_s25;
            end if;
            if rst = '1' then
                valid_s26 <= '0';
            elsif ce = '1' then
                valid_s26 <= valid_s25;
            end if;
        end if;
    end process;

    -- ---- stage 26 ----
    -- setup.light.unit_x
    setup_light_unit_x_n559 <= setup_light_unit_x_n558_s26 when setup_light_unit_x_n557_s26(0) = '1' else signed(resize(setup_light_unit_x_n556_s26, 21));
    setup_light_unit_x_x_sum <= resize(setup_light_unit_x_n559, 22) + 22x"000002";
    setup_light_unit_x_x_cut <= setup_light_unit_x_x_sum(21 downto 2);
    setup_light_unit_x_x_over <= "1" when setup_light_unit_x_x_cut(19) = '0' and (or setup_light_unit_x_x_cut(18 downto 17)) = '1' else "0";
    setup_light_unit_x_x_under <= "1" when setup_light_unit_x_x_cut(19) = '1' and (and setup_light_unit_x_x_cut(18 downto 17)) = '0' else "0";
    setup_light_unit_x_x <= 18x"1ffff" when setup_light_unit_x_x_over(0) = '1' else 18x"20000" when setup_light_unit_x_x_under(0) = '1' else setup_light_unit_x_x_cut(17 downto 0);
    -- setup.light.unit_y
    setup_light_unit_y_n773 <= setup_light_unit_y_n772_s26 when setup_light_unit_y_n771_s26(0) = '1' else signed(resize(setup_light_unit_y_n770_s26, 21));
    setup_light_unit_y_y_sum <= resize(setup_light_unit_y_n773, 22) + 22x"000002";
    setup_light_unit_y_y_cut <= setup_light_unit_y_y_sum(21 downto 2);
    setup_light_unit_y_y_over <= "1" when setup_light_unit_y_y_cut(19) = '0' and (or setup_light_unit_y_y_cut(18 downto 17)) = '1' else "0";
    setup_light_unit_y_y_under <= "1" when setup_light_unit_y_y_cut(19) = '1' and (and setup_light_unit_y_y_cut(18 downto 17)) = '0' else "0";
    setup_light_unit_y_y <= 18x"1ffff" when setup_light_unit_y_y_over(0) = '1' else 18x"20000" when setup_light_unit_y_y_under(0) = '1' else setup_light_unit_y_y_cut(17 downto 0);
    -- setup.light.unit_z
    setup_light_unit_z_n987 <= setup_light_unit_z_n986_s26 when setup_light_unit_z_n985_s26(0) = '1' else signed(resize(setup_light_unit_z_n984_s26, 21));
    setup_light_unit_z_z_sum <= resize(setup_light_unit_z_n987, 22) + 22x"000002";
    setup_light_unit_z_z_cut <= setup_light_unit_z_z_sum(21 downto 2);
    setup_light_unit_z_z_over <= "1" when setup_light_unit_z_z_cut(19) = '0' and (or setup_light_unit_z_z_cut(18 downto 17)) = '1' else "0";
    setup_light_unit_z_z_under <= "1" when setup_light_unit_z_z_cut(19) = '1' and (and setup_light_unit_z_z_cut(18 downto 17)) = '0' else "0";
    setup_light_unit_z_z <= 18x"1ffff" when setup_light_unit_z_z_over(0) = '1' else 18x"20000" when setup_light_unit_z_z_under(0) = '1' else setup_light_unit_z_z_cut(17 downto 0);
    -- setup.half.unit_x
    setup_half_unit_x_n1524 <= setup_half_unit_x_n1523_s26 when setup_half_unit_x_n1522_s26(0) = '1' else signed(resize(setup_half_unit_x_n1521_s26, 21));
    setup_half_unit_x_x_sum <= resize(setup_half_unit_x_n1524, 22) + 22x"000002";
    setup_half_unit_x_x_cut <= setup_half_unit_x_x_sum(21 downto 2);
    setup_half_unit_x_x_over <= "1" when setup_half_unit_x_x_cut(19) = '0' and (or setup_half_unit_x_x_cut(18 downto 17)) = '1' else "0";
    setup_half_unit_x_x_under <= "1" when setup_half_unit_x_x_cut(19) = '1' and (and setup_half_unit_x_x_cut(18 downto 17)) = '0' else "0";
    setup_half_unit_x_x <= 18x"1ffff" when setup_half_unit_x_x_over(0) = '1' else 18x"20000" when setup_half_unit_x_x_under(0) = '1' else setup_half_unit_x_x_cut(17 downto 0);
    -- setup.half.unit_y
    setup_half_unit_y_n1738 <= setup_half_unit_y_n1737_s26 when setup_half_unit_y_n1736_s26(0) = '1' else signed(resize(setup_half_unit_y_n1735_s26, 21));
    setup_half_unit_y_y_sum <= resize(setup_half_unit_y_n1738, 22) + 22x"000002";
    setup_half_unit_y_y_cut <= setup_half_unit_y_y_sum(21 downto 2);
    setup_half_unit_y_y_over <= "1" when setup_half_unit_y_y_cut(19) = '0' and (or setup_half_unit_y_y_cut(18 downto 17)) = '1' else "0";
    setup_half_unit_y_y_under <= "1" when setup_half_unit_y_y_cut(19) = '1' and (and setup_half_unit_y_y_cut(18 downto 17)) = '0' else "0";
    setup_half_unit_y_y <= 18x"1ffff" when setup_half_unit_y_y_over(0) = '1' else 18x"20000" when setup_half_unit_y_y_under(0) = '1' else setup_half_unit_y_y_cut(17 downto 0);
    -- setup.half.unit_z
    setup_half_unit_z_n1952 <= setup_half_unit_z_n1951_s26 when setup_half_unit_z_n1950_s26(0) = '1' else signed(resize(setup_half_unit_z_n1949_s26, 21));
    setup_half_unit_z_z_sum <= resize(setup_half_unit_z_n1952, 22) + 22x"000002";
    setup_half_unit_z_z_cut <= setup_half_unit_z_z_sum(21 downto 2);
    setup_half_unit_z_z_over <= "1" when setup_half_unit_z_z_cut(19) = '0' and (or setup_half_unit_z_z_cut(18 downto 17)) = '1' else "0";
    setup_half_unit_z_z_under <= "1" when setup_half_unit_z_z_cut(19) = '1' and (and setup_half_unit_z_z_cut(18 downto 17)) = '0' else "0";
    setup_half_unit_z_z <= 18x"1ffff" when setup_half_unit_z_z_over(0) = '1' else 18x"20000" when setup_half_unit_z_z_under(0) = '1' else setup_half_unit_z_z_cut(17 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                setup_light_unit_x_x_s27 <= setup_light_unit_x_x;
                setup_light_unit_y_y_s27 <= setup_light_unit_y_y;
                setup_light_unit_z_z_s27 <= setup_light_unit_z_z;
                setup_half_unit_x_x_s27 <= setup_half_unit_x_x;
                setup_half_unit_y_y_s27 <= setup_half_unit_y_y;
                setup_half_unit_z_z_s27 <= setup_half_unit_z_z;
                setup_bump_unit_x_x_s27 <= setup_bump_unit_x_x_s26;
                setup_bump_unit_y_y_s27 <= setup_bump_unit_y_y_s26;
                setup_bump_unit_z_z_s27 <= setup_bump_unit_z_z_s26;
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
    dot_l_n2835 <= setup_light_unit_x_x_s27 * setup_bump_unit_x_x_s27;
    dot_l_n2836 <= setup_light_unit_y_y_s27 * setup_bump_unit_y_y_s27;
    dot_l_n2837 <= setup_light_unit_z_z_s27 * setup_bump_unit_z_z_s27;
    -- dot_h
    dot_h_n2841 <= setup_half_unit_x_x_s27 * setup_bump_unit_x_x_s27;
    dot_h_n2842 <= setup_half_unit_y_y_s27 * setup_bump_unit_y_y_s27;
    dot_h_n2843 <= setup_half_unit_z_z_s27 * setup_bump_unit_z_z_s27;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                dot_l_n2835_s28 <= dot_l_n2835;
                dot_l_n2836_s28 <= dot_l_n2836;
                dot_l_n2837_s28 <= dot_l_n2837;
                dot_h_n2841_s28 <= dot_h_n2841;
                dot_h_n2842_s28 <= dot_h_n2842;
                dot_h_n2843_s28 <= dot_h_n2843;
            end if;
            if rst = '1' then
                valid_s28 <= '0';
            elsif ce = '1' then
                valid_s28 <= valid_s27;
            end if;
        end if;
    end process;

    -- ---- stage 28 ----
    -- dot_l
    dot_l_n2838 <= resize(dot_l_n2835_s28, 37) + resize(dot_l_n2836_s28, 37);
    dot_l_n2839 <= resize(dot_l_n2838, 38) + resize(dot_l_n2837_s28, 38);
    -- dot_h
    dot_h_n2844 <= resize(dot_h_n2841_s28, 37) + resize(dot_h_n2842_s28, 37);
    dot_h_n2845 <= resize(dot_h_n2844, 38) + resize(dot_h_n2843_s28, 38);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                dot_l_n2839_s29 <= dot_l_n2839;
                dot_h_n2845_s29 <= dot_h_n2845;
            end if;
            if rst = '1' then
                valid_s29 <= '0';
            elsif ce = '1' then
                valid_s29 <= valid_s28;
            end if;
        end if;
    end process;

    -- ---- stage 29 ----
    dot_l_sum <= resize(dot_l_n2839_s29, 39) + 39x"0000008000";
    dot_l_cut <= dot_l_sum(38 downto 16);
    dot_l_over <= "1" when dot_l_cut(22) = '0' and (or dot_l_cut(21 downto 20)) = '1' else "0";
    dot_l_under <= "1" when dot_l_cut(22) = '1' and (and dot_l_cut(21 downto 20)) = '0' else "0";
    dot_l <= 21x"0fffff" when dot_l_over(0) = '1' else 21x"100000" when dot_l_under(0) = '1' else dot_l_cut(20 downto 0);
    dot_h_sum <= resize(dot_h_n2845_s29, 39) + 39x"0000008000";
    dot_h_cut <= dot_h_sum(38 downto 16);
    dot_h_over <= "1" when dot_h_cut(22) = '0' and (or dot_h_cut(21 downto 20)) = '1' else "0";
    dot_h_under <= "1" when dot_h_cut(22) = '1' and (and dot_h_cut(21 downto 20)) = '0' else "0";
    dot_h <= 21x"0fffff" when dot_h_over(0) = '1' else 21x"100000" when dot_h_under(0) = '1' else dot_h_cut(20 downto 0);
    -- diffuse
    diffuse_n2847 <= unsigned(dot_l(20 downto 20));
    diffuse_n2848 <= signed(shift_left(resize(setup_light_length_n43, 21), 16)) when diffuse_n2847(0) = '1' else dot_l;
    diffuse_n2849_over <= "1" when diffuse_n2848(20) = '0' and (or diffuse_n2848(19 downto 17)) = '1' else "0";
    diffuse_n2849_under <= unsigned(diffuse_n2848(20 downto 20));
    diffuse_n2849 <= 17x"1ffff" when diffuse_n2849_over(0) = '1' else 17x"00000" when diffuse_n2849_under(0) = '1' else unsigned(diffuse_n2848(16 downto 0));
    diffuse_n2851 <= "1" when diffuse_n2850 < diffuse_n2849 else "0";
    diffuse_n2852 <= diffuse_n2850 when diffuse_n2851(0) = '1' else diffuse_n2849;
    -- (unit)
    n2858 <= unsigned(dot_h(20 downto 20));
    n2859 <= signed(shift_left(resize(setup_light_length_n43, 21), 16)) when n2858(0) = '1' else dot_h;
    specular_index_over <= "1" when n2859(20) = '0' and (or n2859(19 downto 17)) = '1' else "0";
    specular_index_under <= unsigned(n2859(20 downto 20));
    specular_index <= 17x"1ffff" when specular_index_over(0) = '1' else 17x"00000" when specular_index_under(0) = '1' else unsigned(n2859(16 downto 0));
    n2861 <= specular_index(16 downto 16);
    n2862 <= specular_index(15 downto 0);
    n2863 <= n2862;
    -- specular
    specular_n2864 <= n2863(15 downto 6);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                diffuse_n2852_s30 <= diffuse_n2852;
                n2858_s30 <= n2858;
                n2861_s30 <= n2861;
                specular_row <= specular_rom(to_integer(specular_n2864));
            end if;
            if rst = '1' then
                valid_s30 <= '0';
            elsif ce = '1' then
                valid_s30 <= valid_s29;
            end if;
        end if;
    end process;

    -- ---- stage 30 ----
    -- diffuse
    diffuse_n2855 <= diffuse_n2852_s30 * diffuse_n2853;
    -- specular
    specular_n2865 <= specular_row;
    -- (unit)
    n2868 <= n2866 when n2861_s30(0) = '1' else specular_n2865;
    specular_next <= n2867 when n2858_s30(0) = '1' else n2868;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                diffuse_n2855_s31 <= diffuse_n2855;
                specular_next_s31 <= specular_next;
            end if;
            if rst = '1' then
                valid_s31 <= '0';
            elsif ce = '1' then
                valid_s31 <= valid_s30;
            end if;
        end if;
    end process;

    -- ---- stage 31 ----
    -- diffuse
    diffuse_n2856 <= resize(diffuse_n2855_s31, 35) + shift_left(resize(diffuse_n2854, 35), 16);
    diffuse_diffuse_sum <= resize(diffuse_n2856, 36) + 36x"000008000";
    diffuse_diffuse_cut <= diffuse_diffuse_sum(35 downto 16);
    diffuse_diffuse_over <= "1" when (or diffuse_diffuse_cut(19 downto 16)) = '1' else "0";
    diffuse_diffuse <= 16x"ffff" when diffuse_diffuse_over(0) = '1' else diffuse_diffuse_cut(15 downto 0);
    -- (unit)
    n2870 <= resize(diffuse_diffuse, 17) + resize(specular_next_s31, 17);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                diffuse_diffuse_s32 <= diffuse_diffuse;
                specular_next_s32 <= specular_next_s31;
                n2870_s32 <= n2870;
            end if;
            if rst = '1' then
                valid_s32 <= '0';
            elsif ce = '1' then
                valid_s32 <= valid_s31;
            end if;
        end if;
    end process;

    -- ---- stage 32 ----
    intensity_next_over <= "1" when (or n2870_s32(16 downto 16)) = '1' else "0";
    intensity_next <= 16x"ffff" when intensity_next_over(0) = '1' else n2870_s32(15 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                diffuse <= diffuse_diffuse_s32;
                specular <= specular_next_s32;
                intensity <= intensity_next;
            end if;
            if rst = '1' then
                valid_s33 <= '0';
            elsif ce = '1' then
                valid_s33 <= valid_s32;
            end if;
        end if;
    end process;

    -- ---- stage 33 ----

    valid_out <= valid_s33;
end architecture;
