package tompkins.ui;

import tompkins.ui.photograph.PhotographView;
import tompkins.ui.picture.Picture;
import tompkins.ui.ray.PixelProbe;

/** Nobody who listens to a photograph. */
public class SilentListener implements PhotographView.Listener {

    @Override
    public void shown(Picture picture) {}

    @Override
    public void read(PixelProbe.Reading reading) {}

    @Override
    public void pinned(PixelProbe.Reading reading, String picture) {}

    @Override
    public void noPicture(String message) {}

    @Override
    public void failed(String message) {}

    @Override
    public void clicks(PhotographView.Click now) {}
}
