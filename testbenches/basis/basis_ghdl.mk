# basis: binormal and tangent from normal and tangent: N x CT, normalised, x N
# make -f basis_ghdl.mk             runs the VHDL testbench
# make -f basis_ghdl.mk wave        runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run wave clean
# A library for this module alone. It holds paths: after the folder has moved, make clean.
GHDL = --std=08 --workdir=ghdl_basis
run: ghdl_basis/work-obj08.cf
	ghdl -r $(GHDL) basis_tb
wave: ghdl_basis/work-obj08.cf
	ghdl -r $(GHDL) basis_tb --vcd=basis_tb.vcd
ghdl_basis/work-obj08.cf: $(HDL)/basis.vhd basis_tb.vhd
	rm -rf ghdl_basis
	mkdir ghdl_basis
	ghdl -a $(GHDL) $^
clean:
	rm -rf ghdl_basis basis_tb.vcd
