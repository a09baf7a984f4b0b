#include "image/display_transform.h"

#include <OpenColorIO/OpenColorIO.h>

#include <algorithm>
#include <cmath>

namespace gg {

namespace {

namespace ocio = OCIO_NAMESPACE;

float encoded(float light) {
    return light <= 0.0031308F ? 12.92F * light : 1.055F * std::pow(light, 1 / 2.4F) - 0.055F;
}

float decoded(float code) {
    return code <= 0.04045F ? code / 12.92F : std::pow((code + 0.055F) / 1.055F, 2.4F);
}

// The chain of transforms that Blender builds from its view settings.
ocio::ConstProcessorRcPtr make_processor(const ocio::ConstConfigRcPtr& config, const DisplaySettings& settings,
                                         float scale, float exponent) {
    const ocio::GroupTransformRcPtr chain = ocio::GroupTransform::Create();
    const ocio::MatrixTransformRcPtr exposure = ocio::MatrixTransform::Create();
    const double matrix[16] = {scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, 1};
    exposure->setMatrix(matrix);
    chain->appendTransform(exposure);
    std::string from = ocio::ROLE_SCENE_LINEAR;
    if (!settings.look.empty()) {
        const std::string to =
            ocio::LookTransform::GetLooksResultColorSpace(config, config->getCurrentContext(), settings.look.c_str());
        const ocio::LookTransformRcPtr look = ocio::LookTransform::Create();
        look->setSrc(from.c_str());
        look->setDst(to.c_str());
        look->setLooks(settings.look.c_str());
        chain->appendTransform(look);
        from = to;
    }
    const ocio::DisplayViewTransformRcPtr view = ocio::DisplayViewTransform::Create();
    view->setSrc(from.c_str());
    view->setLooksBypass(!settings.look.empty());
    view->setDisplay(settings.device.c_str());
    view->setView(settings.view.c_str());
    chain->appendTransform(view);
    if (exponent != 1) {
        const ocio::ExponentTransformRcPtr gamma = ocio::ExponentTransform::Create();
        const double exponents[4] = {exponent, exponent, exponent, 1};
        gamma->setValue(exponents);
        chain->appendTransform(gamma);
    }
    return config->getProcessor(chain, ocio::TRANSFORM_DIR_FORWARD);
}

}  // namespace

struct DisplayTransform::Processor {
    ocio::ConstCPUProcessorRcPtr cpu;
};

DisplayTransform::DisplayTransform(const DisplaySettings& settings)
    : scale_(std::exp2(settings.exposure)), exponent_(1 / std::max(settings.gamma, 1e-6F)), curves_(settings.curves) {
    if (settings.config.empty()) {
        return;
    }
    try {
        const ocio::ConstConfigRcPtr config = ocio::Config::CreateFromFile(settings.config.c_str());
        const ocio::ConstProcessorRcPtr chain = make_processor(config, settings, scale_, exponent_);
        processor_ = std::make_unique<const Processor>(Processor{chain->getDefaultCPUProcessor()});
    } catch (const std::exception& error) {
        failure_ = error.what();
    }
}

DisplayTransform::~DisplayTransform() = default;

void DisplayTransform::encode(std::span<Rgb> pixels) const {
    for (Rgb& pixel : pixels) {
        pixel = is_finite(pixel) ? pixel : Rgb(0.0F);
        if (curves_) {
            pixel = (*curves_)(pixel);
        }
    }
    if (processor_) {
        ocio::PackedImageDesc image(pixels.data(), static_cast<long>(pixels.size()), 1, 3);
        processor_->cpu->apply(image);
    } else {
        for (Rgb& pixel : pixels) {
            for (int channel = 0; channel < 3; ++channel) {
                pixel[channel] = std::pow(encoded(std::clamp(scale_ * pixel[channel], 0.0F, 1.0F)), exponent_);
            }
        }
    }
    for (Rgb& pixel : pixels) {
        for (int channel = 0; channel < 3; ++channel) {
            pixel[channel] = std::isnan(pixel[channel]) ? 0.0F : std::clamp(pixel[channel], 0.0F, 1.0F);
        }
    }
}

void DisplayTransform::show(std::span<Rgb> pixels) const {
    encode(pixels);
    for (Rgb& pixel : pixels) {
        pixel = {decoded(pixel.r), decoded(pixel.g), decoded(pixel.b)};
    }
}

}  // namespace gg
