# illumination: light of a pixel from light, halfway and perturbed normal vector in the texture frame
# make -f illumination_ghdl.mk             runs the VHDL testbench
# make -f illumination_ghdl.mk wave        runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run wave clean
# A library for this module alone. It holds paths: after the folder has moved, make clean.
GHDL = --std=08 --workdir=ghdl_illumination
run: ghdl_illumination/work-obj08.cf
	ghdl -r $(GHDL) illumination_tb
wave: ghdl_illumination/work-obj08.cf
	ghdl -r $(GHDL) illumination_tb --vcd=illumination_tb.vcd
ghdl_illumination/work-obj08.cf: $(HDL)/illumination.vhd illumination_tb.vhd
	rm -rf ghdl_illumination
	mkdir ghdl_illumination
	ghdl -a $(GHDL) $^
clean:
	rm -rf ghdl_illumination illumination_tb.vcd
