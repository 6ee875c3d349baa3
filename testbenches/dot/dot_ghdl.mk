# dot: dot product of three: exact products and sums, one rounding
# make -f dot_ghdl.mk             runs the VHDL testbench
# make -f dot_ghdl.mk wave        runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run wave clean
# A library for this module alone. It holds paths: after the folder has moved, make clean.
GHDL = --std=08 --workdir=ghdl_dot
run: ghdl_dot/work-obj08.cf
	ghdl -r $(GHDL) dot_tb
wave: ghdl_dot/work-obj08.cf
	ghdl -r $(GHDL) dot_tb --vcd=dot_tb.vcd
ghdl_dot/work-obj08.cf: $(HDL)/dot.vhd dot_tb.vhd
	rm -rf ghdl_dot
	mkdir ghdl_dot
	ghdl -a $(GHDL) $^
clean:
	rm -rf ghdl_dot dot_tb.vcd
