# ernst: light of a bump-mapped pixel by matrix, normalisation and Cartesian dot products
# make -f ernst_ghdl.mk             runs the VHDL testbench
# make -f ernst_ghdl.mk wave        runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run wave clean
# A library for this module alone. It holds paths: after the folder has moved, make clean.
GHDL = --std=08 --workdir=ghdl_ernst
run: ghdl_ernst/work-obj08.cf
	ghdl -r $(GHDL) ernst_tb
wave: ghdl_ernst/work-obj08.cf
	ghdl -r $(GHDL) ernst_tb --vcd=ernst_tb.vcd
ghdl_ernst/work-obj08.cf: $(HDL)/ernst.vhd ernst_tb.vhd
	rm -rf ghdl_ernst
	mkdir ghdl_ernst
	ghdl -a $(GHDL) $^
clean:
	rm -rf ghdl_ernst ernst_tb.vcd
