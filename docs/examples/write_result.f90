! Hands the results of another program to plunge: a standing wave by linear theory.
!
!   gfortran $(pkg-config --variable=fortran plunge-result) write_result.f90 $(pkg-config --libs plunge-result)
program write_result
  use plunge_result
  implicit none
  integer, parameter :: dp = c_double, points = 161, outputs = 21
  real(dp), parameter :: H = 2, g = 9.81_dp, rho = 1000, length = 4, amplitude = 0.04_dp
  real(dp) :: k, omega, rest, E, t, walls(2, 4), surface(2, points)
  type(c_ptr) :: r
  integer :: i, j, code

  k = acos(-1.0_dp) / length
  omega = sqrt(g * k * tanh(k * H))
  rest = rho * g * length * H**2 / 2
  E = rho * g * length * amplitude**2 / 4
  walls = reshape([0.0_dp, 3.0_dp, 0.0_dp, 0.0_dp, length, 0.0_dp, length, 3.0_dp], [2, 4])

  r = plunge_result_open("airy-f.h5" // c_null_char, H, g, rho, length / (points - 1))
  code = plunge_result_names(r, "airy" // c_null_char, "theirs" // c_null_char, "A small standing wave" // c_null_char)
  code = plunge_result_wall(r, 4, walls, 0)
  code = plunge_result_rest(r, rest)
  code = plunge_result_gauge(r, "middle" // c_null_char, length / 4)
  do i = 0, outputs - 1
    t = 0.1_dp * i
    do j = 1, points
      surface(1, j) = length * (j - 1) / (points - 1)
      surface(2, j) = H + amplitude * cos(k * surface(1, j)) * cos(omega * t)
    end do
    code = plunge_result_surface(r, t, points, surface)
    code = plunge_result_energy(r, t, E * sin(omega * t)**2, E * cos(omega * t)**2 + rest, 0.0_dp, 0.0_dp)
    code = plunge_result_elevation(r, 0, t, surface(2, 41))
  end do
  if (plunge_result_close(r, c_null_char) /= 0) error stop "the result could not be written"
end program
