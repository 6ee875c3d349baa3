# combine: diffuse light plus the differences of height samples: the emboss of one to eight lights
# make -f combine_ghdl.mk             runs the VHDL testbench
# make -f combine_ghdl.mk wave        runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run wave clean
# A library for this module alone. It holds paths: after the folder has moved, make clean.
GHDL = --std=08 --workdir=ghdl_combine
run: ghdl_combine/work-obj08.cf
	ghdl -r $(GHDL) combine_tb
wave: ghdl_combine/work-obj08.cf
	ghdl -r $(GHDL) combine_tb --vcd=combine_tb.vcd
ghdl_combine/work-obj08.cf: $(HDL)/combine.vhd combine_tb.vhd
	rm -rf ghdl_combine
	mkdir ghdl_combine
	ghdl -a $(GHDL) $^
clean:
	rm -rf ghdl_combine combine_tb.vcd
