# rsqrt: 1/sqrt(a) by a table, a table with interpolation, or a table and a Newton step
# make -f rsqrt_newton_ghdl.mk             runs the VHDL testbench
# make -f rsqrt_newton_ghdl.mk wave        runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run wave clean
# A library for this module alone. It holds paths: after the folder has moved, make clean.
GHDL = --std=08 --workdir=ghdl_rsqrt_newton
run: ghdl_rsqrt_newton/work-obj08.cf
	ghdl -r $(GHDL) rsqrt_newton_tb
wave: ghdl_rsqrt_newton/work-obj08.cf
	ghdl -r $(GHDL) rsqrt_newton_tb --vcd=rsqrt_newton_tb.vcd
ghdl_rsqrt_newton/work-obj08.cf: $(HDL)/rsqrt_newton.vhd rsqrt_newton_tb.vhd
	rm -rf ghdl_rsqrt_newton
	mkdir ghdl_rsqrt_newton
	ghdl -a $(GHDL) $^
clean:
	rm -rf ghdl_rsqrt_newton rsqrt_newton_tb.vcd
