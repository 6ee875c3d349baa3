# rsqrt: 1/sqrt(a) by a table, a table with interpolation, or a table and a Newton step
# make -f rsqrt_ghdl.mk             runs the VHDL testbench
# make -f rsqrt_ghdl.mk wave        runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run wave clean
# A library for this module alone. It holds paths: after the folder has moved, make clean.
GHDL = --std=08 --workdir=ghdl_rsqrt
run: ghdl_rsqrt/work-obj08.cf
	ghdl -r $(GHDL) rsqrt_tb
wave: ghdl_rsqrt/work-obj08.cf
	ghdl -r $(GHDL) rsqrt_tb --vcd=rsqrt_tb.vcd
ghdl_rsqrt/work-obj08.cf: $(HDL)/rsqrt.vhd rsqrt_tb.vhd
	rm -rf ghdl_rsqrt
	mkdir ghdl_rsqrt
	ghdl -a $(GHDL) $^
clean:
	rm -rf ghdl_rsqrt rsqrt_tb.vcd
