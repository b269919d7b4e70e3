! What library/plunge_result.h declares, for Fortran. Texts end with c_null_char; points(2, n) are x, y.
module plunge_result
  use iso_c_binding
  implicit none

  interface
    type(c_ptr) function plunge_result_open(path, H, g, density, spacing) bind(c)
      import
      character(kind=c_char), intent(in) :: path(*)
      real(c_double), value :: H, g, density, spacing
    end function

    integer(c_int) function plunge_result_close(r, ended) bind(c)
      import
      type(c_ptr), value :: r
      character(kind=c_char), intent(in) :: ended(*)
    end function

    integer(c_int) function plunge_result_names(r, program_, run, title) bind(c)
      import
      type(c_ptr), value :: r
      character(kind=c_char), intent(in) :: program_(*), run(*), title(*)
    end function

    integer(c_int) function plunge_result_wall(r, n, points, closed) bind(c)
      import
      type(c_ptr), value :: r
      integer(c_int), value :: n, closed
      real(c_double), intent(in) :: points(2, *)
    end function

    integer(c_int) function plunge_result_rest(r, potential) bind(c)
      import
      type(c_ptr), value :: r
      real(c_double), value :: potential
    end function

    integer(c_int) function plunge_result_probe(r, name, x, y, length) bind(c)
      import
      type(c_ptr), value :: r
      character(kind=c_char), intent(in) :: name(*)
      real(c_double), value :: x, y, length
    end function

    integer(c_int) function plunge_result_gauge(r, name, x) bind(c)
      import
      type(c_ptr), value :: r
      character(kind=c_char), intent(in) :: name(*)
      real(c_double), value :: x
    end function

    integer(c_int) function plunge_result_term(r, name, help) bind(c)
      import
      type(c_ptr), value :: r
      character(kind=c_char), intent(in) :: name(*), help(*)
    end function

    integer(c_int) function plunge_result_surface(r, time, n, points) bind(c)
      import
      type(c_ptr), value :: r
      real(c_double), value :: time
      integer(c_int), value :: n
      real(c_double), intent(in) :: points(2, *)
    end function

    ! first(pieces + 1) counts points from 0
    integer(c_int) function plunge_result_pieces(r, time, pieces, first, closed, points) bind(c)
      import
      type(c_ptr), value :: r
      real(c_double), value :: time
      integer(c_int), value :: pieces
      integer(c_int), intent(in) :: first(*), closed(*)
      real(c_double), intent(in) :: points(2, *)
    end function

    ! what is unknown is an absent argument
    integer(c_int) function plunge_result_particles(r, time, n, points, pressure, density, mass, volume, velocity) bind(c)
      import
      type(c_ptr), value :: r
      real(c_double), value :: time
      integer(c_int), value :: n
      real(c_double), intent(in) :: points(2, *)
      real(c_double), intent(in), optional :: pressure(*), density(*), mass(*), volume(*), velocity(2, *)
    end function

    integer(c_int) function plunge_result_energy(r, time, kinetic, potential, internal, removed, terms) bind(c)
      import
      type(c_ptr), value :: r
      real(c_double), value :: time, kinetic, potential, internal, removed
      real(c_double), intent(in), optional :: terms(*)
    end function

    integer(c_int) function plunge_result_step(r, time, dt, volume, removed, evaluations, wall_time) bind(c)
      import
      type(c_ptr), value :: r
      real(c_double), value :: time, dt, volume, removed, evaluations, wall_time
    end function

    ! probes and gauges are numbered from 0
    integer(c_int) function plunge_result_pressure(r, probe, time, pressure) bind(c)
      import
      type(c_ptr), value :: r
      integer(c_int), value :: probe
      real(c_double), value :: time, pressure
    end function

    integer(c_int) function plunge_result_elevation(r, gauge, time, elevation) bind(c)
      import
      type(c_ptr), value :: r
      integer(c_int), value :: gauge
      real(c_double), value :: time, elevation
    end function

    integer(c_int) function plunge_result_event(r, name, time, x, y) bind(c)
      import
      type(c_ptr), value :: r
      character(kind=c_char), intent(in) :: name(*)
      real(c_double), value :: time, x, y
    end function
  end interface
end module
