# sampler: texels and fractions of texture coordinates, nearest or bilinear, wrapped or clamped
# make -f sampler_ghdl.mk             runs the VHDL testbench
# make -f sampler_ghdl.mk wave        runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run wave clean
# A library for this module alone. It holds paths: after the folder has moved, make clean.
GHDL = --std=08 --workdir=ghdl_sampler
run: ghdl_sampler/work-obj08.cf
	ghdl -r $(GHDL) sampler_tb
wave: ghdl_sampler/work-obj08.cf
	ghdl -r $(GHDL) sampler_tb --vcd=sampler_tb.vcd
ghdl_sampler/work-obj08.cf: $(HDL)/sampler.vhd sampler_tb.vhd
	rm -rf ghdl_sampler
	mkdir ghdl_sampler
	ghdl -a $(GHDL) $^
clean:
	rm -rf ghdl_sampler sampler_tb.vcd
