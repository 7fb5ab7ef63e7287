"""Scenario files: inheritance, overrides, and one line for whatever is wrong with them."""

from pathlib import Path

import pytest

from estimator.errors import InputError
from scenarios.load import load_scenario

ABOUT = "about: A drive for a test.\n"


def write(folder: Path, name: str, text: str) -> str:
    path = folder / f"{name}.yaml"
    path.write_text(text)
    return str(path)


def test_a_file_gets_its_name_and_the_defaults(tmp_path: Path) -> None:
    scenario = load_scenario(write(tmp_path, "mine", ABOUT + "drive: {speed_mps: 4}"))
    assert (scenario.name, scenario.about) == ("mine", "A drive for a test.")
    assert (scenario.world.drive.speed_mps, scenario.world.drive.rate_hz) == (4.0, 10.0)
    assert scenario.rig.reference == "front"


def test_base_gives_what_the_file_does_not(tmp_path: Path) -> None:
    write(tmp_path, "lower", ABOUT + "drive: {speed_mps: 4, rate_hz: 20}")
    scenario = load_scenario(write(tmp_path, "upper", "base: ./lower.yaml\ndrive: {speed_mps: 6}"))
    assert (scenario.world.drive.speed_mps, scenario.world.drive.rate_hz) == (6.0, 20.0)


def test_set_wins_over_the_file_and_the_last_set_wins() -> None:
    scenario = load_scenario("first_drive", ["drive.speed_mps=8", "drive.speed_mps=9", "weather={}"])
    assert (scenario.world.drive.speed_mps, scenario.world.drive.distance_m) == (9.0, 50.0)


def test_a_rig_file_is_looked_up_from_the_file_that_names_it(tmp_path: Path) -> None:
    bundled = Path(__file__).parents[3] / "scenarios" / "rigs" / "gap.yaml"
    (tmp_path / "deep").mkdir()
    own = bundled.read_text().replace("rotation_deg: 3.0", "rotation_deg: 2.5")
    (tmp_path / "deep" / "own.yaml").write_text(own)
    write(tmp_path / "deep", "lower", ABOUT + "rig: ./own.yaml")
    scenario = load_scenario(write(tmp_path, "upper", "base: deep/lower.yaml"))
    assert scenario.rig.prior.rotation_deg == 2.5


def test_bases_in_a_circle_are_refused(tmp_path: Path) -> None:
    write(tmp_path, "a", ABOUT + "base: ./b.yaml")
    with pytest.raises(InputError, match="circle: b -> a -> b"):
        load_scenario(write(tmp_path, "b", ABOUT + "base: ./a.yaml"))


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "got nothing, wanted a scenario"),
        ("- 1", "got list, wanted a scenario"),
        ("drive: {speed_mps: 5}", "about: missing"),
        ("about: [", "not valid YAML"),
        (ABOUT + ABOUT, "key 'about' is given twice"),
        (
            ABOUT + "drive: {speed: 5}",
            "drive.speed: unknown key; there are: distance_m, grip, lateral_mps2",
        ),
        (ABOUT + "speed: 5", "speed: unknown key; there are: about, drive"),
        (ABOUT + "drive: {speed_mps: .nan}", "drive.speed_mps: got nan, wanted a finite number, 0.2 to 40"),
        (ABOUT + "drive: {speed_mps: -1}", "drive.speed_mps: got -1, wanted 0.2 to 40"),
        (ABOUT + "drive: {speed_mps: 41}", "got 41, wanted 0.2 to 40"),
        (
            ABOUT + "miscalibration: {events: [{at_s: 1, camera: reer, kind: knock, rotation_deg: 1}]}",
            "miscalibration.events[0].camera: got 'reer', wanted a camera of the rig; there are: front_r",
        ),
        (
            ABOUT + "miscalibration: {events: [{at_s: 1, camera: rear, kind: knock}]}",
            "miscalibration.events[0]: nothing would move; wanted rotation_deg or translation_mm above 0",
        ),
        (ABOUT + "drive: {speed_mps: '5'}", "drive.speed_mps: got '5', wanted a number, 0.2 to 40"),
        (ABOUT + "drive: {sped_mps: 5}", "speed_mps (did you mean 'speed_mps'?)"),
        (ABOUT + "drive: 5", "drive: got 5, wanted keys with values"),
        (ABOUT + "base: nope", "base: scenario 'nope' is not known; there are: "),
        (ABOUT + "base: [1]", "base: got [1], wanted the name or file"),
        (ABOUT + "rig: gapp", "(did you mean 'gap'?)"),
        (ABOUT + "rig: ./none.yaml", "none.yaml: no such rig file"),
        (ABOUT + "1: 2", "[1]: got 1, wanted "),
    ],
)
def test_a_wrong_file_is_one_line(tmp_path: Path, text: str, message: str) -> None:
    with pytest.raises(InputError) as error:
        load_scenario(write(tmp_path, "wrong", text))
    assert message in str(error.value)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize(
    ("setting", "message"),
    [
        ("drive.speed_mps", "wanted KEY=VALUE"),
        ("drive..speed_mps=3", "wanted KEY=VALUE"),
        ("drive.speed_mps=[", "not valid YAML"),
        (
            "drive.sped_mps=3",
            "--set: drive.sped_mps: unknown key; there are: distance_m, grip, lateral_mps2",
        ),
        ("base=quick_look", "a base is chosen in the file"),
        ("drive.speed_mps=", "got None, wanted a number"),
    ],
)
def test_a_wrong_set_is_one_line(setting: str, message: str) -> None:
    with pytest.raises(InputError) as error:
        load_scenario("first_drive", [setting])
    assert message in str(error.value)


def test_a_file_beside_it_that_was_meant_is_named(tmp_path: Path) -> None:
    write(tmp_path, "lower", ABOUT)
    with pytest.raises(InputError, match=r"base: scenario 'lower' is not .* \(did you mean the file"):
        load_scenario(write(tmp_path, "upper", "base: lower"))


def test_an_error_names_the_file_that_holds_the_key(tmp_path: Path) -> None:
    write(tmp_path, "lower", ABOUT + "drive: {rate_hz: 0}")
    with pytest.raises(InputError, match=r"lower\.yaml: drive\.rate_hz: got 0"):
        load_scenario(write(tmp_path, "upper", "base: ./lower.yaml\ndrive: {speed_mps: 6}"))


def test_an_unknown_scenario_lists_what_there_is() -> None:
    with pytest.raises(InputError, match=r"is not known \(did you mean 'first_drive'\?\); there are: "):
        load_scenario("first_driv")


@pytest.mark.parametrize(
    "settings",
    [["weather.night=2"], ["weather.dusk=1"], ["weather.tunnel=1", "street={kind: tunnel, length_m: 70}"]],
    ids=["night", "dusk", "tunnel"],
)
def test_lamps_in_a_renderer_that_cannot_draw_them_are_refused(settings: list[str]) -> None:
    with pytest.raises(InputError, match="renderer: got filament, which cannot draw the lamps of weather"):
        load_scenario("first_drive", ["renderer=filament", *settings])
    assert load_scenario("first_drive", ["renderer=pyrender", *settings]).world.renderer == "pyrender"


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        (
            ["drive.distance_m=500"],
            "--set: drive.distance_m: got 500, wanted over 0 to 65 where street.length_m is 70; "
            "it needs a street of at least 505 m",
        ),
        (
            ["street={kind: loop, length_m: 70}"],
            "--set: street.length_m: got 70, wanted 200 to 800 for a street of kind loop; "
            "below it has no room for once round a block",
        ),
        (
            ["street={kind: car_park, length_m: 301}"],
            "--set: street.length_m: got 301, wanted 90 to 300 for a street of kind car_park; beyond",
        ),
        (
            ["drive.grip=0.1", "street.slope_percent=15"],
            "--set: street.slope_percent: got 15, wanted 0 to 3 where drive.grip is 0.1: its wheels",
        ),
        (["truth=[depth, depth]"], "--set: truth: got ['depth', 'depth'], wanted each channel once"),
        (
            ["faults=[{kind: off, camera: [rear, rear]}]"],
            "--set: faults[0].camera: got ['rear', 'rear'], wanted each camera once",
        ),
        (
            ["rig=fisheye", "faults=[{kind: wrong_intrinsics, camera: left_front, focal_percent: -50}]"],
            "--set: faults[0]: of camera left_front it makes a kannala_brandt lens that folds over",
        ),
    ],
)
def test_settings_that_do_not_go_together_are_refused(settings: list[str], message: str) -> None:
    with pytest.raises(InputError) as error:
        load_scenario("first_drive", settings)
    assert str(error.value).startswith(message) and "\n" not in str(error.value)


def test_a_lens_that_folds_over_is_refused_with_the_rig_file(tmp_path: Path) -> None:
    bundled = Path(__file__).parents[3] / "scenarios" / "rigs" / "gap.yaml"
    (tmp_path / "own.yaml").write_text(bundled.read_text().replace("[-0.22, 0.055,", "[-0.4, 0.0,", 1))
    with pytest.raises(
        InputError, match=r"own\.yaml: cameras\.left_front: got a brown_conrady lens that fol"
    ):
        load_scenario(write(tmp_path, "mine", ABOUT + "rig: ./own.yaml"))


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        (["weather.tunnel=3"], "weather.tunnel: got 3, wanted 0 where street.kind is bend"),
        (["weather.dusk=1", "weather.night=2"], "weather.dusk: got 1 with weather.night 2, wanted one"),
        (["weather.flare=1", "weather.fog=5"], "weather.flare: got 1, wanted 0 or thinner clouds"),
    ],
    ids=["tunnel", "dusk", "flare"],
)
def test_weather_that_cannot_be_is_refused(settings: list[str], message: str) -> None:
    with pytest.raises(InputError, match=f"--set: {message}"):
        load_scenario("first_drive", settings)


def test_a_shutter_slower_than_the_images_is_refused() -> None:
    with pytest.raises(
        InputError, match=r"rolling_shutter_s: got 0\.05, wanted 0 to 0\.0167 where drive\.rate_hz is 60"
    ):
        load_scenario("first_drive", ["drive.rate_hz=60", "sensor.rolling_shutter_s=0.05"])


def test_humps_on_a_motorway_are_refused() -> None:
    with pytest.raises(InputError, match=r"speed_bumps: got 3, wanted 0 where street\.kind is motorway"):
        load_scenario("motorway", ["street.speed_bumps=3"])
