# {{ title }}
# make -f {{ name }}_ghdl.mk             runs the VHDL testbench
# make -f {{ name }}_ghdl.mk wave        runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
{%- if tables %}
TABLES = {{ tables | join(" ") }}
{%- endif %}
.PHONY: run wave clean
# A library for this module alone. It holds paths: after the folder has moved, make clean.
GHDL = --std=08 --workdir=ghdl_{{ name }}
run: ghdl_{{ name }}/work-obj08.cf{{ " $(TABLES)" if tables }}
	ghdl -r $(GHDL) {{ name }}_tb
wave: ghdl_{{ name }}/work-obj08.cf{{ " $(TABLES)" if tables }}
	ghdl -r $(GHDL) {{ name }}_tb --vcd={{ name }}_tb.vcd
ghdl_{{ name }}/work-obj08.cf: $(HDL)/{{ name }}.vhd {{ top ~ ".vhd " if bench }}{{ name }}_tb.vhd
	rm -rf ghdl_{{ name }}
	mkdir ghdl_{{ name }}
	ghdl -a $(GHDL) $^
{%- if tables %}
ifneq ($(HDL),.)
$(TABLES): %.hex: $(HDL)/%.hex
	cp $< $@
endif
{%- endif %}
clean:
	rm -rf ghdl_{{ name }} {{ name }}_tb.vcd
