# peercy: light and halfway vector in the texture frame, by matrix, with the bump vector normalised
# make -f peercy_ghdl.mk             runs the VHDL testbench
# make -f peercy_ghdl.mk wave        runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run wave clean
# A library for this module alone. It holds paths: after the folder has moved, make clean.
GHDL = --std=08 --workdir=ghdl_peercy
run: ghdl_peercy/work-obj08.cf
	ghdl -r $(GHDL) peercy_tb
wave: ghdl_peercy/work-obj08.cf
	ghdl -r $(GHDL) peercy_tb --vcd=peercy_tb.vcd
ghdl_peercy/work-obj08.cf: $(HDL)/peercy.vhd peercy_tb.vhd
	rm -rf ghdl_peercy
	mkdir ghdl_peercy
	ghdl -a $(GHDL) $^
clean:
	rm -rf ghdl_peercy peercy_tb.vcd
