# normalise: block normalisation: three words shifted by the leading zeros of the largest
# make -f normalise_ghdl.mk             runs the VHDL testbench
# make -f normalise_ghdl.mk wave        runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run wave clean
# A library for this module alone. It holds paths: after the folder has moved, make clean.
GHDL = --std=08 --workdir=ghdl_normalise
run: ghdl_normalise/work-obj08.cf
	ghdl -r $(GHDL) normalise_tb
wave: ghdl_normalise/work-obj08.cf
	ghdl -r $(GHDL) normalise_tb --vcd=normalise_tb.vcd
ghdl_normalise/work-obj08.cf: $(HDL)/normalise.vhd normalise_tb.vhd
	rm -rf ghdl_normalise
	mkdir ghdl_normalise
	ghdl -a $(GHDL) $^
clean:
	rm -rf ghdl_normalise normalise_tb.vcd
