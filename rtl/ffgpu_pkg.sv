// Types shared by every unit.
package ffgpu_pkg;

  parameter int unsigned ChannelWidth = 8;

  typedef logic [ChannelWidth-1:0] channel_t;  // 8-bit unsigned normalised colour channel
  typedef logic [ChannelWidth-1:0] weight_t;   // 0.8 fixed point filter weight

endpackage
