# emboss: texture coordinates displaced by the direction of a light, for embossing
# make -f emboss_printed_ghdl.mk             runs the VHDL testbench
# make -f emboss_printed_ghdl.mk wave        runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run wave clean
# A library for this module alone. It holds paths: after the folder has moved, make clean.
GHDL = --std=08 --workdir=ghdl_emboss_printed
run: ghdl_emboss_printed/work-obj08.cf
	ghdl -r $(GHDL) emboss_printed_tb
wave: ghdl_emboss_printed/work-obj08.cf
	ghdl -r $(GHDL) emboss_printed_tb --vcd=emboss_printed_tb.vcd
ghdl_emboss_printed/work-obj08.cf: $(HDL)/emboss_printed.vhd emboss_printed_tb.vhd
	rm -rf ghdl_emboss_printed
	mkdir ghdl_emboss_printed
	ghdl -a $(GHDL) $^
clean:
	rm -rf ghdl_emboss_printed emboss_printed_tb.vcd
